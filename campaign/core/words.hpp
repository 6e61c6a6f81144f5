#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "campaign/core/attempt.hpp"
#include "campaign/core/campaign.hpp"

/// The words that users and the store see for states and outcomes; schemas/results.sql lists the same.
namespace softwall::campaign {

[[nodiscard]] std::string_view word_of(CaseState state);
[[nodiscard]] std::string_view word_of(AttemptOutcome outcome);
/// "queued", "running", "unknown"; "gone"
[[nodiscard]] std::string_view word_of(Presence presence);
[[nodiscard]] std::optional<CaseState> state_of(std::string_view word);
[[nodiscard]] std::optional<AttemptOutcome> outcome_of(std::string_view word);

/// "1 case", "2 cases"; noun: one that takes an s.
[[nodiscard]] std::string counted(std::int64_t number, const std::string& noun);

/// Four digits, and no zeros at the end: "656.3"
[[nodiscard]] std::string short_number(double value);

}  // namespace softwall::campaign
