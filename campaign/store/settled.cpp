#include "campaign/store/settled.hpp"

#include <algorithm>
#include <array>

#include "campaign/observe/observe.hpp"
#include "campaign/store/import_results.hpp"
#include "campaign/system/file_system.hpp"
#include "solver/case/time_comparison.hpp"

namespace softwall::campaign {

bool is_settled(const CampaignCase& one, const CaseRecord& known, const RunFiles& run) {
  if (one.starts_others || known.state != CaseState::kFinished ||
      !has_reached(known.reached_time, one.definition.run.end_time))
    return false;
  const std::string looked_at = std::max(known.state_since, known.checkpoints_seen);
  const std::string of_directory = change_time(run.directory);
  if (of_directory.empty() || of_directory >= looked_at) return false;
  const std::array inside = {run.checkpoints(), run.case_file(), run.summary(), run.statistics()};
  return std::ranges::all_of(inside, [&](const auto& place) { return change_time(place) < looked_at; });
}

Observation settled_observation(const CampaignCase& one, const CaseRecord& known) {
  Observation seen;
  seen.case_id = one.definition.id;
  seen.state = CaseState::kFinished;
  seen.reason = known.state_reason;
  seen.step = known.reached_step;
  seen.time = known.reached_time;
  seen.end_time = one.definition.run.end_time;
  seen.attempts = known.attempts;
  seen.attempts_without_progress = known.attempts_without_progress;
  seen.seconds_per_step = known.seconds_per_step;
  seen.measured_ranks = known.measured_ranks;
  return seen;
}

std::vector<Observation> observe_with_records(const Campaign& campaign, const std::filesystem::path& folder,
                                              const Launcher& launcher, const CaseRecords& records) {
  std::vector<Observation> all(campaign.cases.size());
  std::vector<const CampaignCase*> others;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const CampaignCase& one = campaign.cases[i];
    const auto known = records.find(one.definition.id);
    if (known != records.end() && is_settled(one, known->second, run_files(folder, one))) {
      all[i] = settled_observation(one, known->second);
      continue;
    }
    others.push_back(&one);
    places.push_back(i);
  }
  const auto seen = observe_all(others, folder, launcher);
  for (std::size_t k = 0; k < others.size(); ++k) {
    const auto known = records.find(seen[k].case_id);
    all[places[k]] = known == records.end() ? seen[k] : with_history(seen[k], known->second);
  }
  return all;
}

}  // namespace softwall::campaign
