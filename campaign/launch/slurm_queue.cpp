#include "campaign/launch/slurm_queue.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "campaign/launch/slurm_command.hpp"
#include "campaign/launch/start_program.hpp"
#include "campaign/system/clock.hpp"

namespace softwall::campaign {
namespace {

struct State {
  std::string_view word;
  Presence presence;
  bool leaves_no_process;
};

/// squeue(1), JOB STATE CODES. One that Slurm holds up waits, whether or not it keeps its nodes.
constexpr std::array<State, 25> kStates = {{
    {"PENDING", Presence::kQueued, false},       {"CONFIGURING", Presence::kQueued, false},
    {"REQUEUED", Presence::kQueued, false},      {"REQUEUE_FED", Presence::kQueued, false},
    {"REQUEUE_HOLD", Presence::kQueued, false},  {"SPECIAL_EXIT", Presence::kQueued, false},
    {"RESV_DEL_HOLD", Presence::kQueued, false}, {"RUNNING", Presence::kRunning, false},
    {"COMPLETING", Presence::kRunning, false},   {"RESIZING", Presence::kRunning, false},
    {"SIGNALING", Presence::kRunning, false},    {"STAGE_OUT", Presence::kRunning, false},
    {"STOPPED", Presence::kQueued, false},       {"SUSPENDED", Presence::kQueued, false},
    {"COMPLETED", Presence::kGone, true},        {"FAILED", Presence::kGone, true},
    {"CANCELLED", Presence::kGone, true},        {"TIMEOUT", Presence::kGone, true},
    {"OUT_OF_MEMORY", Presence::kGone, true},    {"PREEMPTED", Presence::kGone, true},
    {"DEADLINE", Presence::kGone, true},         {"REVOKED", Presence::kGone, true},
    {"LAUNCH_FAILED", Presence::kGone, true},    {"BOOT_FAIL", Presence::kGone, false},
    {"NODE_FAIL", Presence::kGone, false},
}};

const State* known(std::string_view word) {
  const auto found = std::ranges::find(kStates, word, &State::word);
  return found == kStates.end() ? nullptr : &*found;
}

bool is_number(std::string_view text) {  // 12, 12_3 and 12_[1-3] of an array, 12+0 of several in one
  return !text.empty() && text[0] >= '0' && text[0] <= '9' &&
         text.find_first_not_of("0123456789_+-[],%.") == std::string_view::npos;
}

bool is_state(std::string_view text) {
  return !text.empty() && text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_") == std::string_view::npos;
}

std::optional<int> whole(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The first fields of a line, and all the rest of it as the last one.
template <std::size_t count>
std::optional<std::array<std::string_view, count>> split(std::string_view line) {
  std::array<std::string_view, count> fields;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const auto end = line.find('|');
    if (end == std::string_view::npos) return std::nullopt;
    fields[i] = line.substr(0, end);
    line.remove_prefix(end + 1);
  }
  fields[count - 1] = line;
  return fields;
}

template <class ParseLine>
std::optional<std::vector<QueuedJob>> parse_lines(std::string_view text, const ParseLine& parse_line) {
  std::vector<QueuedJob> jobs;
  while (!text.empty()) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return std::nullopt;  // cut off
    auto job = parse_line(text.substr(0, end));
    if (!job) return std::nullopt;
    jobs.push_back(std::move(*job));
    text.remove_prefix(end + 1);
  }
  return jobs;
}

/// "3:0", status and signal, as sacct has them.
std::optional<int> exit_code_in(std::string_view text) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto status = whole(text.substr(0, colon)), signal = whole(text.substr(colon + 1));
  if (!status || !signal) return std::nullopt;
  return *signal > 0 ? 128 + *signal : *status;
}

}  // namespace

Presence presence_in(std::string_view state) {
  const State* const found = known(state);
  return found ? found->presence : Presence::kUnknown;
}

bool leaves_no_process(std::string_view state) {
  const State* const found = known(state);
  return found && found->leaves_no_process;
}

std::optional<std::vector<QueuedJob>> parse_squeue(std::string_view text) {
  return parse_lines(text, [](std::string_view line) -> std::optional<QueuedJob> {
    const auto fields = split<5>(line);
    if (!fields) return std::nullopt;
    const auto& [number, state, status, why, name] = *fields;
    const auto wait_status = whole(status);
    if (!is_number(number) || !is_state(state) || !wait_status || !name.ends_with('|')) return std::nullopt;
    QueuedJob job{std::string(number), std::string(name.substr(0, name.size() - 1)), std::string(state),
                  std::string(why), std::nullopt};
    if (presence_in(state) == Presence::kGone) job.exit_code = exit_code_of(*wait_status);
    return job;
  });
}

std::optional<std::vector<QueuedJob>> parse_sacct(std::string_view text) {
  return parse_lines(text, [](std::string_view line) -> std::optional<QueuedJob> {
    const auto fields = split<4>(line);
    if (!fields) return std::nullopt;
    const auto& [number, state, status, name] = *fields;
    const auto word = state.substr(0, state.find(' '));  // "CANCELLED by 1000"
    if (!is_number(number) || !is_state(word)) return std::nullopt;
    return QueuedJob{std::string(number), std::string(name), std::string(word), "", exit_code_in(status)};
  });
}

void SlurmQueue::refresh() {
  const double now = monotonic_seconds();
  if (now - asked_at_ < pause_) return;
  asked_at_ = now;
  const Answer answer = ask_slurm(
      "squeue",
      {"--noheader", of_this_user(), "--states=all", "--Format=JobID:|,State:|,exit_code:|,Reason:|,Name:|"},
      pace_.answer);
  auto jobs = answer.exit_code == 0 ? parse_squeue(answer.output) : std::nullopt;
  const bool was_silent = !answered_;
  answered_ = jobs.has_value();
  if (!jobs) {
    trouble_ = answer.exit_code == 0 ? "squeue: an answer that cannot be read: " + in_one_line(answer.output)
                                     : trouble_in(answer, "squeue");
    pause_ = std::min(std::max(pace_.shortest, 2 * pause_), pace_.longest_silence);
    return;
  }
  const bool changed = was_silent || answer.output != text_;
  text_ = answer.output;
  pause_ = changed ? pace_.shortest : std::min(std::max(pace_.shortest, 1.3 * pause_), pace_.longest);
  take(std::move(*jobs));
}

void SlurmQueue::take(std::vector<QueuedJob> jobs) {
  jobs_.clear();
  for (QueuedJob& job : jobs) {
    std::vector<QueuedJob>& of_its_name = jobs_[job.name];
    of_its_name.push_back(std::move(job));
  }
}

void SlurmQueue::hurry() { pause_ = std::min(pause_, pace_.shortest); }

const std::vector<QueuedJob>& SlurmQueue::called(const std::string& name) const {
  static const std::vector<QueuedJob> kNone;
  const auto found = jobs_.find(name);
  return found == jobs_.end() ? kNone : found->second;
}

std::unordered_map<std::string, QueuedJob> SlurmQueue::past(const std::vector<std::string>& names) const {
  constexpr std::size_t kNamesAtOnce = 400;  // 200 characters each; an argument may have 128 KiB
  std::unordered_map<std::string, QueuedJob> found;
  for (std::size_t first = 0; first < names.size(); first += kNamesAtOnce) {
    std::string list;
    for (std::size_t i = first; i < std::min(names.size(), first + kNamesAtOnce); ++i)
      list += (list.empty() ? "" : ",") + names[i];
    const Answer answer =
        ask_slurm("sacct",
                  {"--noheader", "--parsable2", "--allocations", of_this_user(), "--starttime=now-30days",
                   "--name=" + list, "--format=JobIDRaw,State,ExitCode,JobName"},
                  pace_.answer);
    const auto jobs = answer.exit_code == 0 ? parse_sacct(answer.output) : std::nullopt;
    if (!jobs) continue;
    for (const QueuedJob& job : *jobs) found[job.name] = job;
  }
  return found;
}

}  // namespace softwall::campaign
