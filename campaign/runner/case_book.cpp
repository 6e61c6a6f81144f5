#include "campaign/runner/case_book.hpp"

#include <algorithm>
#include <stdexcept>

#include "campaign/observe/observe.hpp"
#include "campaign/store/import_results.hpp"
#include "campaign/store/settled.hpp"
#include "solver/case/time_comparison.hpp"

namespace softwall::campaign {

CaseBook::CaseBook(Campaign campaign, std::filesystem::path folder, Store& store, Progress& progress)
    : campaign_(std::move(campaign)),
      folder_(std::move(folder)),
      store_(store),
      progress_(progress),
      observations_(campaign_.cases.size()),
      settled_(campaign_.cases.size(), false) {
  for (std::size_t i = 0; i < campaign_.cases.size(); ++i) {
    index_.emplace(campaign_.cases[i].definition.id, i);
    started_by_[campaign_.cases[i].precursor_id].push_back(i);
  }
}

const CampaignCase& CaseBook::find(const std::string& case_id) const {
  return campaign_.cases[index_of(case_id)];
}

RunFiles CaseBook::files_of(const CampaignCase& one) const { return run_files(folder_, one); }

const Observation& CaseBook::seen(const CampaignCase& one) const {
  return observations_[index_of(one.definition.id)];
}

void CaseBook::look_at(const CampaignCase& one) {
  const auto known = store_.find_case(one.definition.id);
  look_at(one, observe_files(one, files_of(one)), known.value_or(CaseRecord{}));
}

void CaseBook::look_at(const CampaignCase& one, const Observation& files, const CaseRecord& known) {
  const std::string& id = one.definition.id;
  Observation now = with_history(files, known);
  now.retry_allowed = now.retry_allowed && !paused_.contains(id) && !given_up_.contains(id);
  observations_[index_of(id)] = may_start_over_ ? without_lost_checkpoints(now) : now;
}

void CaseBook::settle(const CampaignCase& one, const CaseRecord& known) {
  const std::size_t i = index_of(one.definition.id);
  observations_[i] = settled_observation(one, known);
  settled_[i] = true;
}

bool CaseBook::is_settled(const CampaignCase& one) const { return settled_[index_of(one.definition.id)]; }

void CaseBook::mark_unfinished(const CampaignCase& one, const std::filesystem::path& last_checkpoint,
                               const std::string& reason) {
  Observation& now = observations_[index_of(one.definition.id)];
  now.state = CaseState::kInterrupted;
  now.early = false;
  now.newest_checkpoint = last_checkpoint;
  now.reason = reason;
}

void CaseBook::forgive_divergence(const CampaignCase& one) {
  Observation& now = observations_[index_of(one.definition.id)];
  now = without_divergence(now);
}

void CaseBook::mark_running(const CampaignCase& one, Presence presence) {
  Observation& now = observations_[index_of(one.definition.id)];
  now.running = true;
  now.presence = presence;
  now.state = CaseState::kRunning;
}

void CaseBook::look_at_starting_points() {
  for (const CampaignCase& one : campaign_.cases) look_at_starting_point(one);
}

void CaseBook::look_at_starting_point(const CampaignCase& one) {
  Observation& now = observations_[index_of(one.definition.id)];
  if (!one.starts_others || now.state != CaseState::kFinished || !is_needed(one)) return;
  Ladder ladder;
  try {
    ladder = check(one);
  } catch (const std::system_error& error) {
    ladder.unreadable = error.what();
  }
  now.newest_checkpoint = ladder.newest;
  now.needs_person = ladder.unreadable;
  if (!ladder.unreadable.empty()) return;  // nothing else is known of it than that it has finished
  if (ladder.newest && has_reached(ladder.header.time, one.definition.run.end_time)) return;
  now.state = CaseState::kInterrupted;
  now.reason = "its last checkpoint was damaged";
  now.step = ladder.newest ? ladder.header.step : 0;
  now.time = ladder.newest ? ladder.header.time : 0.0;
  if (!ladder.newest && !may_start_over_) now.needs_person = kNoCheckpointLeft;
}

void CaseBook::give_up(const CampaignCase& one, const std::string& reason) {
  given_up_[one.definition.id] = reason;
}

void CaseBook::pause(const CampaignCase& one, const std::string& reason) {
  paused_[one.definition.id] = reason;
}

void CaseBook::pause_unfinished(const std::string& reason) {
  for (std::size_t i = 0; i < campaign_.cases.size(); ++i) {
    const CampaignCase& one = campaign_.cases[i];
    observations_[i] = observe_files(one, files_of(one));
    if (observations_[i].state != CaseState::kFinished) pause(one, reason);
  }
}

Ladder CaseBook::check(const CampaignCase& one) {
  const RunFiles run = files_of(one);
  Ladder ladder = check_ladder(run, one.definition.id);
  if (ladder.set_aside.empty()) return ladder;
  for (const SetAside& bad : ladder.set_aside) {
    progress_.event(one.definition.label + ": " + bad.file.filename().string() + " set aside: " + bad.reason,
                    Progress::Kind::kBad);
  }
  store_.record_checkpoints(one.definition.id, checkpoint_records(run, ladder.set_aside));
  return ladder;
}

std::size_t CaseBook::index_of(const std::string& case_id) const {
  const auto found = index_.find(case_id);
  if (found == index_.end()) throw std::logic_error("no case " + case_id + " in this campaign");
  return found->second;
}

bool CaseBook::is_needed(const CampaignCase& start) const {
  const auto found = started_by_.find(start.definition.id);
  if (found == started_by_.end()) return false;
  return std::ranges::any_of(found->second,
                             [&](std::size_t i) { return has_yet_to_start(observations_[i]); });
}

}  // namespace softwall::campaign
