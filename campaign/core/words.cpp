#include "campaign/core/words.hpp"

#include <array>
#include <cstdio>

namespace softwall::campaign {

namespace {

template <class Value>
struct Word {
  Value value;
  std::string_view word;
};

constexpr std::array<Word<CaseState>, 6> kStates = {{
    {CaseState::kNew, "new"},
    {CaseState::kRunning, "running"},
    {CaseState::kFinished, "finished"},
    {CaseState::kInterrupted, "interrupted"},
    {CaseState::kDiverged, "diverged"},
    {CaseState::kFailed, "failed"},
}};

constexpr std::array<Word<Presence>, 4> kPresences = {{
    {Presence::kQueued, "queued"},
    {Presence::kRunning, "running"},
    {Presence::kGone, "gone"},
    {Presence::kUnknown, "unknown"},
}};

constexpr std::array<Word<AttemptOutcome>, 14> kOutcomes = {{
    {AttemptOutcome::kFinished, "finished"},
    {AttemptOutcome::kInterrupted, "interrupted"},
    {AttemptOutcome::kDiverged, "diverged"},
    {AttemptOutcome::kBadCase, "bad case"},
    {AttemptOutcome::kBadCheckpoint, "bad checkpoint"},
    {AttemptOutcome::kIoFailure, "i/o failure"},
    {AttemptOutcome::kTimeout, "timeout"},
    {AttemptOutcome::kKilled, "killed"},
    {AttemptOutcome::kOutOfMemory, "out of memory"},
    {AttemptOutcome::kNodeFailure, "node failure"},
    {AttemptOutcome::kStalled, "stalled"},
    {AttemptOutcome::kNotStarted, "not started"},
    {AttemptOutcome::kLost, "lost"},
    {AttemptOutcome::kFailed, "failed"},
}};

template <class Value, std::size_t count>
std::string_view find_word(const std::array<Word<Value>, count>& words, Value value) {
  for (const auto& entry : words) {
    if (entry.value == value) return entry.word;
  }
  return "";  // refused by the CHECK of the table
}

template <class Value, std::size_t count>
std::optional<Value> find_value(const std::array<Word<Value>, count>& words, std::string_view word) {
  for (const auto& entry : words) {
    if (entry.word == word) return entry.value;
  }
  return std::nullopt;
}

}  // namespace

std::string_view word_of(CaseState state) { return find_word(kStates, state); }

std::string_view word_of(AttemptOutcome outcome) { return find_word(kOutcomes, outcome); }

std::string_view word_of(Presence presence) { return find_word(kPresences, presence); }

std::optional<CaseState> state_of(std::string_view word) { return find_value(kStates, word); }

std::optional<AttemptOutcome> outcome_of(std::string_view word) { return find_value(kOutcomes, word); }

std::string counted(std::int64_t number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

}  // namespace softwall::campaign
