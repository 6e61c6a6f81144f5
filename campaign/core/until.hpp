#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "solver/case/bad_input.hpp"

/// The object "until" of a campaign file: how small the 95 % intervals of named results are to be. A case
/// that has come to all of them ends before its end time. It is no part of a case.
namespace softwall::campaign {

struct IntervalTarget {
  std::string quantity;   ///< "re_tau"
  double most = 0;        ///< largest half width of its interval, in its unit or as a share of its value
  bool relative = false;  ///< a share
};

/// What the schema cannot say: half widths that are neither a number nor a percentage above 0, intervals that
/// this flow does not have. flow: its name in a campaign file.
[[nodiscard]] std::vector<Mistake> until_mistakes(const nlohmann::json& until, const std::string& flow);

/// Needs an "until" without mistakes.
[[nodiscard]] std::vector<IntervalTarget> interval_targets(const nlohmann::json& until);

/// A result with the half width of its 95 % interval, where it has one.
struct UncertainResult {
  double value = 0;
  std::optional<double> ci95;
};

/// Whether every target is met by a value and an interval that are known. None is met where there are none.
[[nodiscard]] bool are_met(const std::vector<IntervalTarget>& targets,
                           const std::function<UncertainResult(const std::string& quantity)>& result_of);

/// "re_tau within 2 %, delta_max within 0.001"; human-readable.
[[nodiscard]] std::string describe(const std::vector<IntervalTarget>& targets);

}  // namespace softwall::campaign
