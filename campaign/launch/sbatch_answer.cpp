#include "campaign/launch/sbatch_answer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace softwall::campaign {
namespace {

template <std::size_t count>
bool holds_one_of(const std::string& text, const std::array<const char*, count>& phrases) {
  return std::ranges::any_of(phrases, [&](const char* phrase) { return text.find(phrase) != text.npos; });
}

}  // namespace

bool may_pass(const Answer& answer) {
  static constexpr std::array<const char*, 11> kPassing = {
      "Unable to contact",  "timed out",     "Zero Bytes", "Protocol authentication",
      "temporarily",        "Connection",    "connection", "configuration source",
      "node configuration", "not available", "busy"};
  return !answer.exit_code || holds_one_of(answer.errors, kPassing);
}

bool is_doubtful(const Answer& answer) {
  static constexpr std::array<const char*, 2> kCutOff = {"timed out", "Zero Bytes"};
  const bool refused =
      answer.exit_code && *answer.exit_code > 0 && *answer.exit_code < 128 && !answer.errors.empty();
  return !refused || holds_one_of(answer.errors, kCutOff);
}

std::optional<std::string> job_number_in(const Answer& answer) {
  if (answer.exit_code != 0) return std::nullopt;
  const auto digits = answer.output.find_first_not_of("0123456789");
  if (digits == 0 || digits == std::string::npos) return std::nullopt;
  if (answer.output[digits] != '\n' && answer.output[digits] != ';') return std::nullopt;
  return answer.output.substr(0, digits);
}

}  // namespace softwall::campaign
