#include "campaign/core/effect.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "campaign/core/parameters.hpp"
#include "solver/case/json_schema.hpp"
#include "solver/case/json_text.hpp"
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

/// 60, not 60.0, as a person writes it.
std::string quoted_number(double number) { return quoted(normalised_number(number)); }

/// When the first block of an averaging window begins; blocks follow each other from the first sample on.
double first_block_start(const json& statistics, double window_start) {
  const double first = statistics.at("start_time"), length = statistics.at("block_length");
  if (has_reached(first, window_start)) return first;
  return first + length * std::ceil((window_start - first) / length * (1 - kTimeRoundOff));
}

}  // namespace

std::optional<Mistake> never_sampled(const json& filled, double window_start) {
  const json& statistics = filled.at("physics").at("statistics");
  const double end = filled.at("run").at("end_time");
  if (has_reached(window_start, end)) {
    return Mistake{"/physics/statistics/start_time", quoted_number(window_start),
                   "must be less than the end time, " + quoted(filled.at("run").at("end_time")) +
                       ", or no statistics are ever sampled"};
  }
  const double start = first_block_start(statistics, window_start);
  if (has_reached(start, end)) {
    return Mistake{"/physics/statistics/block_length", quoted(statistics.at("block_length")),
                   "must be less, or no block begins between the averages' start, " +
                       quoted_number(window_start) + ", and the end time, " + quoted_number(end)};
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

std::vector<std::string> members_without_effect(const json& physics) {
  std::vector<std::string> found;
  const auto add = [&](bool idle, std::initializer_list<const char*> pointers) {
    if (idle) found.insert(found.end(), pointers.begin(), pointers.end());
  };
  const auto is = [&](const char* pointer, const json& value) {
    const json::json_pointer place(pointer);
    return physics.contains(place) && physics.at(place) == value;
  };
  add(is("/solid/formulation", "reference_map"),
      {"/solid/interface", "/solid/threshold", "/solid/extension", "/solid/min_eigenvalue"});
  add(physics.at("time_step").contains("fixed_dt"), {"/time_step/safety", "/solid/dt_plus"});
  add(is("/initial/amplitude", 0), {"/initial/seed"});
  return found;
}

ExclusionUse::ExclusionUse(const json& exclusions) {
  for (const json& members : exclusions) {
    Exclusion& exclusion = exclusions_.emplace_back();
    for (const auto& [name, wanted] : members.items()) {
      exclusion.values.push_back({.name = name,
                                  .pointer = find_parameter(name)->pointer,
                                  .wanted = wanted,
                                  .nearest = std::nullopt});
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
