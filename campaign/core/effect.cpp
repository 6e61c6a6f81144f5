#include "campaign/core/effect.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "campaign/core/parameters.hpp"
#include "solver/case/json_schema.hpp"
#include "solver/case/time_comparison.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

/// A number, also one that is written as text; NaN for anything else.
double number_in(const json& value) {
  if (value.is_number()) return value.get<double>();
  double number = std::numeric_limits<double>::quiet_NaN();
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    std::from_chars(text.data(), text.data() + text.size(), number);
  }
  return number;
}

double distance(const json& a, const json& b) {
  const double difference = std::abs(number_in(a) - number_in(b));
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

}  // namespace

std::optional<Mistake> never_sampled(const json& filled) {
  const json& statistics = filled.at("physics").at("statistics");
  const double start = statistics.at("start_time"), end = filled.at("run").at("end_time");
  if (has_reached(start, end)) {
    return Mistake{"/physics/statistics/start_time", quoted(statistics.at("start_time")),
                   "must be less than the end time, " + quoted(filled.at("run").at("end_time")) +
                       ", or no statistics are ever sampled"};
  }
  const json& step = filled.at("physics").at("time_step");
  if (!step.contains("fixed_dt")) return std::nullopt;
  const double dt = step.at("fixed_dt"), interval = statistics.at("interval_steps");
  const double steps = std::ceil(end / dt * (1 - kTimeRoundOff));
  const double last_sample = std::floor(steps / interval) * interval * dt;
  if (last_sample > start * (1 + kTimeRoundOff)) return std::nullopt;
  return Mistake{
      "/physics/statistics/interval_steps", quoted(statistics.at("interval_steps")),
      "must be less, or no statistics are sampled in the " + quoted(json(steps)) + " steps to the end"};
}

ExclusionUse::ExclusionUse(const json& exclusions) {
  for (const json& members : exclusions) {
    Exclusion& exclusion = exclusions_.emplace_back();
    for (const auto& [name, wanted] : members.items()) {
      exclusion.values.push_back({name, find_parameter(name)->pointer, wanted, std::nullopt, false});
    }
  }
}

bool ExclusionUse::matches(Exclusion& exclusion, const json& physics) {
  bool all = true;
  for (Value& value : exclusion.values) {
    const bool has = physics.contains(value.pointer) && physics.at(value.pointer) == value.wanted;
    all = all && has;
    value.met = value.met || has;
    if (has || !physics.contains(value.pointer)) continue;
    const json& found = physics.at(value.pointer);
    if (!value.nearest || distance(found, value.wanted) < distance(*value.nearest, value.wanted))
      value.nearest = found;
  }
  return all;
}

bool ExclusionUse::excludes(const json& physics) {
  bool any = false;
  for (Exclusion& exclusion : exclusions_) {
    const bool all = matches(exclusion, physics);
    exclusion.used = exclusion.used || all;
    any = any || all;
  }
  return any;
}

std::vector<Mistake> ExclusionUse::unused() const {
  std::vector<Mistake> mistakes;
  for (std::size_t i = 0; i < exclusions_.size(); ++i) {
    const Exclusion& exclusion = exclusions_[i];
    if (exclusion.used) continue;
    const std::string where = "/sweep/exclude/" + std::to_string(i);
    const auto strange = std::find_if(exclusion.values.begin(), exclusion.values.end(),
                                      [](const Value& value) { return !value.met; });
    if (strange == exclusion.values.end()) {
      mistakes.push_back({where, "excludes nothing", "no case has all of these values: leave it out"});
      continue;
    }
    mistakes.push_back({where + "/" + strange->name, quoted(strange->wanted),
                        "excludes nothing: no case has this value" +
                            (strange->nearest ? "; the nearest is " + quoted(*strange->nearest) : "")});
  }
  return mistakes;
}

}  // namespace softwall::campaign
