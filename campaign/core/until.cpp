#include "campaign/core/until.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "campaign/core/round_off.hpp"
#include "solver/case/json_schema.hpp"
#include "solver/case/json_text.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

constexpr std::string_view kSuffix = "_ci95";  // of the columns of `results` that hold intervals

/// What only a soft wall has.
constexpr std::array<std::string_view, 3> kOfElasticWalls = {"d", "delta_max", "delta_rms"};

/// The share in "2 %", or else a number in the unit of its quantity; nothing where it is neither, or not
/// above 0.
std::optional<IntervalTarget> target_of(const std::string& column, const json& wanted) {
  IntervalTarget target;
  target.quantity = column.substr(0, column.size() - kSuffix.size());
  if (wanted.is_number()) {
    target.most = wanted.get<double>();
  } else {
    const auto& text = wanted.get_ref<const std::string&>();
    double percent = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), percent);
    const std::string unit(end, text.data() + text.size());
    if (error != std::errc() || (unit != "%" && unit != " %")) return std::nullopt;
    target.most = percent / 100;
    target.relative = true;
  }
  if (!std::isfinite(target.most) || target.most <= 0) return std::nullopt;
  return target;
}

/// Why this flow has no such interval; empty: it has.
std::string why_without(const std::string& quantity, const std::string& flow) {
  if (flow != "elastic_wall" && flow != "rigid_channel")
    return "the results of a " + flow + " have no intervals";
  const bool of_walls = std::ranges::find(kOfElasticWalls, quantity) != kOfElasticWalls.end();
  return of_walls && flow == "rigid_channel" ? "a rigid channel has no " + quantity : "";
}

}  // namespace

std::vector<Mistake> until_mistakes(const json& until, const std::string& flow) {
  std::vector<Mistake> mistakes;
  for (const auto& [column, wanted] : until.items()) {
    const std::string where = "/until/" + column;
    const auto target = target_of(column, wanted);
    if (!target) {
      mistakes.push_back(
          {where, quoted(wanted), "must be a number above 0, or a percentage such as \"2 %\""});
    } else if (const std::string why = why_without(target->quantity, flow); !why.empty()) {
      mistakes.push_back({where, quoted(wanted), "has no effect: " + why});
    }
  }
  return mistakes;
}

std::vector<IntervalTarget> interval_targets(const json& until) {
  std::vector<IntervalTarget> targets;
  for (const auto& [column, wanted] : until.items()) targets.push_back(target_of(column, wanted).value());
  return targets;
}

bool are_met(const std::vector<IntervalTarget>& targets,
             const std::function<UncertainResult(const std::string&)>& result_of) {
  return !targets.empty() && std::ranges::all_of(targets, [&](const IntervalTarget& target) {
    const UncertainResult found = result_of(target.quantity);
    const double unit = target.relative ? std::abs(found.value) : 1.0;
    return found.ci95 && std::isfinite(found.value) && *found.ci95 <= target.most * unit;
  });
}

std::string describe(const std::vector<IntervalTarget>& targets) {
  std::string text;
  for (const IntervalTarget& target : targets) {
    const json number =
        normalised_number(target.relative ? without_round_off(target.most * 100) : target.most);
    text += (text.empty() ? "" : ", ") + target.quantity + " within " + quoted(number) +
            (target.relative ? " %" : "");
  }
  return text;
}

}  // namespace softwall::campaign
