#include "campaign/core/existing_cases.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "solver/case/case_id.hpp"
#include "solver/case/time_comparison.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

Continuation found_in(const json& physics) {
  const json& statistics = physics.at("statistics");
  Continuation found{
      {statistics.at("start_time"), statistics.at("interval_steps"), statistics.at("block_length")}};
  if (physics.contains("solid")) found.dt_plus = physics.at("solid").at("dt_plus");
  return found;
}

/// What is left of an id when these are left out: steps between samples stay a part of it.
std::string flow_id(json physics) {
  if (physics.contains("statistics")) {
    physics["statistics"].erase("start_time");
    physics["statistics"].erase("block_length");
  }
  if (physics.contains("solid")) physics["solid"].erase("dt_plus");
  return case_id(physics);
}

/// Whether a whole number of blocks of this length makes one of the length wanted.
bool divides(double length, double wanted) {
  const double number = std::round(wanted / length);
  return number >= 1 && std::abs(number * length - wanted) <= kTimeRoundOff * wanted;
}

}  // namespace

void ExistingCases::add(const json& physics) { by_flow_.emplace(flow_id(physics), found_in(physics)); }

Continuation ExistingCases::continuation_of(const json& physics, bool any_steps) const {
  const Continuation wanted = found_in(physics);
  Continuation best = wanted;
  best.statistics.start_time = 0;
  if (by_flow_.empty()) return best;
  const auto serves = [&](const Continuation& one) {
    return divides(one.statistics.block_length, wanted.statistics.block_length) &&
           (any_steps || one.dt_plus == wanted.dt_plus);
  };
  const auto rank = [&](const Continuation& one) {
    const StatisticsSpec& sampled = one.statistics;
    return std::tuple(one.dt_plus != wanted.dt_plus, sampled.start_time > wanted.statistics.start_time,
                      sampled.block_length != wanted.statistics.block_length, sampled.start_time);
  };
  bool found = false;
  const auto [first, last] = by_flow_.equal_range(flow_id(physics));
  for (auto item = first; item != last; ++item) {
    const Continuation& one = item->second;
    if (!serves(one) || (found && rank(best) <= rank(one))) continue;
    best = one;
    found = true;
  }
  return best;
}

}  // namespace softwall::campaign
