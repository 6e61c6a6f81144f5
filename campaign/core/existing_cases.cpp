#include "campaign/core/existing_cases.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "solver/case/case_id.hpp"
#include "solver/case/time_comparison.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

StatisticsSpec statistics_in(const json& physics) {
  const json& statistics = physics.at("statistics");
  return {statistics.at("start_time"), statistics.at("interval_steps"), statistics.at("block_length")};
}

/// What is left of an id when the averages are left out: steps between samples stay a part of it.
std::string flow_id(json physics) {
  if (physics.contains("statistics")) {
    physics["statistics"].erase("start_time");
    physics["statistics"].erase("block_length");
  }
  return case_id(physics);
}

/// Whether a whole number of blocks of this length makes one of the length wanted.
bool divides(double length, double wanted) {
  const double number = std::round(wanted / length);
  return number >= 1 && std::abs(number * length - wanted) <= kTimeRoundOff * wanted;
}

}  // namespace

void ExistingCases::add(const json& physics) { by_flow_.emplace(flow_id(physics), statistics_in(physics)); }

StatisticsSpec ExistingCases::statistics_for(const json& physics) const {
  const StatisticsSpec wanted = statistics_in(physics);
  StatisticsSpec best{0.0, wanted.interval_steps, wanted.block_length};
  if (by_flow_.empty()) return best;
  const auto rank = [&](const StatisticsSpec& one) {
    return std::tuple(one.start_time > wanted.start_time, one.block_length != wanted.block_length,
                      one.start_time);
  };
  bool found = false;
  const auto [first, last] = by_flow_.equal_range(flow_id(physics));
  for (auto item = first; item != last; ++item) {
    const StatisticsSpec& one = item->second;
    if (!divides(one.block_length, wanted.block_length) || (found && rank(best) <= rank(one))) continue;
    best = one;
    found = true;
  }
  return best;
}

}  // namespace softwall::campaign
