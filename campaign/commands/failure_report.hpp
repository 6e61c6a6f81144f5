#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "campaign/commands/exit_status.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {

/// Why a command ended without doing what it was asked to.
struct FailureReport {
  ExitStatus status;
  std::string text;               ///< for people, lines that end in a line break
  std::vector<Mistake> mistakes;  ///< of an input, each also in the text
};

/// An array of {"where": ..., "given": ..., "allowed": ...}, also of none.
[[nodiscard]] nlohmann::ordered_json json_of_mistakes(const std::vector<Mistake>& mistakes);

/// Tells a failure in words, or as one JSON value: {"error": {"status": 2, "message": "...", "mistakes":
/// [...]}}.
void report_failure(std::ostream& out, const FailureReport& report, bool json);

}  // namespace softwall::campaign
