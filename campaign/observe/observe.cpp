#include "campaign/observe/observe.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <unordered_set>

#include "campaign/core/label.hpp"
#include "campaign/observe/averages.hpp"
#include "campaign/observe/ladder.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/system/file_system.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/time_comparison.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "solver/run_directory/exit_codes.hpp"

namespace softwall::campaign {
namespace {

void observe_ladder(const RunFiles& run, Observation& observation) {
  for (const auto& file : checkpoint_ladder(run)) {
    try {
      const CheckpointHeader header = read_checkpoint_header(file);
      if (header.case_id != observation.case_id) continue;
      observation.newest_checkpoint = file;
      observation.step = std::max(observation.step, header.step);
      observation.time = std::max(observation.time, header.time);
      return;
    } catch (const std::runtime_error& error) {
      if (!tells_nothing_of_contents(error)) continue;  // it will be set aside before the next launch
      observation.needs_person = file.filename().string() + ": " + error.what();
      return;
    }
  }
}

/// What cannot be read is not damaged, and a case that had come far does not start over unasked.
void observe_checkpoints(const RunFiles& run, Observation& observation) {
  try {
    observe_ladder(run, observation);
  } catch (const std::system_error& error) {
    observation.needs_person = error.what();
  }
  if (observation.newest_checkpoint || !observation.needs_person.empty()) return;
  if (checkpoints_are_lost(run, observation.case_id)) observation.needs_person = kNoCheckpointLeft;
}

/// A case that was stopped in order, at a checkpoint, and whose averages there are as precise as they are to
/// be. Whether they still are is asked of the statistics each time: another target, or another window, needs
/// nobody to take back what was decided before.
bool is_finished_early(const Summary& summary, const CampaignCase& campaign_case, const RunFiles& run) {
  const bool in_order = summary.outcome == "interrupted" || summary.outcome == "finished";
  return in_order && !is_finished(summary, campaign_case) && intervals_are_met(campaign_case, run);
}

void apply_summary(const Summary& summary, const CampaignCase& campaign_case, Observation& observation) {
  observation.reason = summary.reason;
  observation.step = std::max(observation.step, summary.step);
  observation.time = std::max(observation.time, summary.time);
  if (summary.attempt_steps > 0) {
    observation.seconds_per_step = summary.wall_seconds / static_cast<double>(summary.attempt_steps);
    observation.measured_ranks = summary.ranks;
  }
  if (is_finished(summary, campaign_case)) {
    observation.state = CaseState::kFinished;
  } else if (summary.outcome == "finished") {
    observation.state = CaseState::kInterrupted;
    observation.reason = "the end time was raised";
  } else if (summary.outcome == "diverged") {
    observation.state = CaseState::kDiverged;
  } else if (summary.outcome == "interrupted") {
    observation.state = CaseState::kInterrupted;
  } else {
    observation.state = CaseState::kFailed;
    observation.retry_allowed = summary.exit_code != static_cast<int>(ExitCode::kBadCase);
  }
}

/// Few digits of an id may be those of two cases. A case file that is missing or damaged tells nothing.
bool may_be_of(const std::filesystem::path& directory, const std::string& case_id) {
  try {
    return read_case(RunFiles{directory}.case_file()).id == case_id;
  } catch (const BadInput&) {
    return true;
  }
}

/// What the solver's lock adds where its launcher knows of no process. Of another user's solver only its own
/// report of its end can be read.
Presence presence_inside(const RunFiles& run, int attempt) {
  const LockState lock = lock_state(run.lock());
  if (lock == LockState::kHeld) return Presence::kRunning;
  if (lock == LockState::kFree) return Presence::kGone;
  const auto summary = read_summary(run, "");
  return summary && summary->attempt >= attempt ? Presence::kGone : Presence::kUnknown;
}

}  // namespace

bool is_finished(const Summary& summary, const CampaignCase& campaign_case) {
  return summary.outcome == "finished" && has_reached(summary.time, campaign_case.definition.run.end_time);
}

RunFiles run_files(const std::filesystem::path& folder, const CampaignCase& campaign_case) {
  return {std::filesystem::absolute(folder) / campaign_case.directory};
}

std::vector<Presence> presences(const std::vector<RunFiles>& runs, const Launcher& launcher) {
  if (runs.empty()) return {};
  std::vector<AttemptPlace> places;
  std::vector<int> attempts;
  std::vector<std::size_t> there;  // nobody works in a directory that has not been made
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!std::filesystem::exists(runs[i].directory)) continue;
    const auto record = read_run_record(runs[i]);
    places.push_back({runs[i].directory, record ? record->handle : Handle()});
    attempts.push_back(record ? record->attempt : 0);
    there.push_back(i);
  }
  const auto seen = launcher.presences(places);
  std::vector<Presence> found(runs.size(), Presence::kGone);
  for (std::size_t k = 0; k < there.size(); ++k) {
    const bool gone = seen[k] == Presence::kGone;
    found[there[k]] = gone ? presence_inside(runs[there[k]], attempts[k]) : seen[k];
  }
  return found;
}

std::vector<bool> occupied(const std::vector<RunFiles>& runs, const Launcher& launcher) {
  std::vector<bool> found;
  for (const Presence presence : presences(runs, launcher)) found.push_back(presence != Presence::kGone);
  return found;
}

bool solver_is_inside(const RunFiles& run) { return lock_is_held(run.lock()); }

bool is_occupied(const RunFiles& run, const Launcher& launcher) { return occupied({run}, launcher).front(); }

Observation observe_files(const CampaignCase& campaign_case, const RunFiles& run) {
  Observation observation;
  observation.case_id = campaign_case.definition.id;
  observation.end_time = campaign_case.definition.run.end_time;
  if (!std::filesystem::exists(run.directory)) return observation;

  if (const auto record = read_run_record(run)) observation.attempts = record->attempt;
  const auto summary = read_summary(run, observation.case_id);
  // An older summary says nothing about an attempt that was started after it and left none.
  const bool speaks = summary && summary->attempt >= observation.attempts;
  if (speaks) observation.attempts = summary->attempt;
  // Nobody needs the checkpoints of a case that is done, except where other cases start from them.
  const bool early = speaks && is_finished_early(*summary, campaign_case, run);
  const bool done = early || (speaks && is_finished(*summary, campaign_case) && !campaign_case.starts_others);
  if (!done) observe_checkpoints(run, observation);
  if (observation.newest_checkpoint) {
    observation.state = CaseState::kInterrupted;
    observation.reason = "ended without a word";
  }
  if (speaks) apply_summary(*summary, campaign_case, observation);
  if (early) {
    observation.early = true;
    observation.state = CaseState::kFinished;
    observation.reason = "finished early: " + describe(campaign_case.until);
  }
  return observation;
}

Observation from_the_beginning(Observation observation) {
  observation.needs_person.clear();
  observation.state = CaseState::kNew;
  observation.step = 0;
  observation.time = 0;
  return observation;
}

bool has_yet_to_start(const Observation& seen) {
  const bool is_over = seen.state == CaseState::kFinished || seen.state == CaseState::kDiverged;
  return !is_over && !seen.running && !seen.newest_checkpoint;
}

Observation without_lost_checkpoints(Observation observation) {
  const bool has_finished = observation.state == CaseState::kFinished;
  return observation.needs_person == kNoCheckpointLeft && !has_finished ? from_the_beginning(observation)
                                                                        : observation;
}

Observation without_divergence(Observation observation) {
  const bool is_cleared = observation.state == CaseState::kDiverged && !observation.newest_checkpoint;
  return is_cleared ? from_the_beginning(observation) : observation;
}

namespace {

/// What there is to be said of an attempt that has not ended.
std::string remark_on(Presence presence) {
  return presence == Presence::kUnknown ? "not known whether it runs" : "";
}

Observation observe_work(const CampaignCase& campaign_case, const RunFiles& run, Presence presence) {
  Observation observation = observe_files(campaign_case, run);
  observation.presence = presence;
  if (presence == Presence::kGone) return observation;
  observation.running = true;
  observation.state = CaseState::kRunning;
  observation.early = false;
  observation.reason = remark_on(presence);  // what it was spoke of an end that is over
  if (const auto status = report_of_work(run, observation)) {
    observation.seconds_per_step = status->seconds_per_step;
    observation.measured_ranks = status->ranks;
  }
  return observation;
}

}  // namespace

/// A solver that was started by hand counts no attempts.
std::optional<Status> report_of_work(const RunFiles& run, const Observation& seen) {
  constexpr int kByHand = 0;
  auto status = seen.running ? read_status(run, seen.case_id) : std::nullopt;
  const bool by_hand = status && status->attempt == kByHand && seen.presence == Presence::kRunning;
  return status && (by_hand || status->attempt >= seen.attempts) ? status : std::nullopt;
}

Observation observe(const CampaignCase& campaign_case, const RunFiles& run, const Launcher& launcher) {
  return observe_work(campaign_case, run, presences({run}, launcher).front());
}

std::vector<Observation> observe_all(const std::vector<const CampaignCase*>& cases,
                                     const std::filesystem::path& folder, const Launcher& launcher) {
  std::vector<RunFiles> runs;
  for (const CampaignCase* one : cases) runs.push_back(run_files(folder, *one));
  const auto seen = presences(runs, launcher);
  std::vector<Observation> all;
  for (std::size_t i = 0; i < runs.size(); ++i) all.push_back(observe_work(*cases[i], runs[i], seen[i]));
  return all;
}

void keep_existing_directories(Campaign& campaign, const std::filesystem::path& folder,
                               const CaseDirectories& existing) {
  std::unordered_set<std::string> kept;
  for (CampaignCase& one : campaign.cases) {
    const std::string& id = one.definition.id;
    const auto [first, last] = existing.equal_range(id.substr(0, kIdDigits));
    std::optional<std::string> found;
    for (auto item = first; item != last && found != one.directory; ++item) {
      const bool has_its_name = item->second == one.directory;
      if (has_its_name || (!found && may_be_of(folder / item->second, id))) found = item->second;
    }
    if (!found) continue;
    one.directory = *found;
    one.definition.label = label_in_directory(*found, id);
    kept.insert(id);
  }
  make_labels_distinct(campaign, kept);
}

}  // namespace softwall::campaign
