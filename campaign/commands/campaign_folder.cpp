#include "campaign/commands/campaign_folder.hpp"

#include <string>
#include <unordered_map>

#include "campaign/core/campaign_file.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/case_directories.hpp"
#include "campaign/observe/ladder.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/store/settled.hpp"
#include "campaign/store/store.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCampaignFile = "campaign.json";

bool is_folder(const fs::path& path) {
  std::error_code unreadable;
  return fs::is_directory(path, unreadable);
}

/// A relative path leads nowhere when the folder that one stands in has been deleted.
void require_current_folder(const fs::path& path) {
  std::error_code gone;
  if (path.is_absolute() || !fs::current_path(gone).empty()) return;
  throw BadInput(path.string(),
                 {{"", "a relative path, but the current folder is not there any more", "an absolute path"}});
}

fs::path existing_campaign_file(const fs::path& path) {
  const fs::path file = campaign_file(path);
  std::error_code unreadable;
  if (is_folder(path) && !fs::exists(file, unreadable)) {
    throw BadInput(path.string(),
                   {{"", "a folder without a campaign.json", "a campaign file, or its folder"}});
  }
  return file;
}

/// The folder without symbolic links, because a solver that works there knows it by this name.
fs::path folder_of(const fs::path& path) {
  const fs::path folder = is_folder(path) ? path : fs::absolute(path).parent_path();
  return fs::weakly_canonical(folder);
}

/// By case id, the starting points that are still of use: of each, whether a case has yet to start from it.
std::unordered_map<std::string, bool> starting_points(const Campaign& campaign,
                                                      const std::vector<Observation>& observations) {
  std::unordered_map<std::string, bool> needed;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const std::string& start = campaign.cases[i].precursor_id;
    if (!start.empty()) needed[start] = needed[start] || has_yet_to_start(observations[i]);
  }
  return needed;
}

/// A starting point from which all cases have started needs its checkpoints no longer; one that has lost them
/// before starts over, where a person lets it.
void look_at_starting_points(const Campaign& campaign, std::vector<Observation>& observations,
                             bool start_over) {
  const auto needed = starting_points(campaign, observations);
  for (Observation& seen : observations) {
    const auto start = needed.find(seen.case_id);
    const bool has_lost_them = seen.state == CaseState::kFinished && seen.needs_person == kNoCheckpointLeft;
    if (start == needed.end() || !has_lost_them) continue;
    if (!start->second)
      seen.needs_person.clear();
    else if (start_over)
      seen = from_the_beginning(seen);
  }
}

}  // namespace

fs::path campaign_file(const fs::path& path) { return is_folder(path) ? path / kCampaignFile : path; }

LoadedCampaign load_campaign(const fs::path& path) {
  require_current_folder(path);
  const fs::path file = existing_campaign_file(path);
  LoadedCampaign loaded{read_campaign(file), folder_of(file), {}, {}};
  const CaseDirectories directories = existing_directories(loaded.folder);
  if (const auto existing = existing_cases(loaded.campaign, loaded.folder, directories); !existing.empty())
    loaded.campaign = read_campaign(file, existing);
  Execution& execution = loaded.campaign.execution;
  execution.cores = cores_to_use(execution.cores, *make_launcher(execution));
  loaded.file = loaded.folder / file.filename();
  loaded.named = file.filename() == kCampaignFile ? loaded.folder : loaded.folder / file.filename();
  keep_existing_directories(loaded.campaign, loaded.folder, directories);
  return loaded;
}

std::vector<Observation> observe_with_history(const LoadedCampaign& loaded, const Launcher& launcher) {
  std::error_code unreadable;
  CaseRecords records;
  if (fs::exists(store_path(loaded.folder), unreadable))
    records = Store::open(loaded.folder, OpenMode::kReadOnly).all_cases();
  return observe_with_records(loaded.campaign, loaded.folder, launcher, records);
}

std::vector<Observation> observe_for_run(const LoadedCampaign& loaded, const Launcher& launcher,
                                         bool start_over) {
  auto observations = observe_with_history(loaded, launcher);
  for (Observation& seen : observations) {
    seen.attempts_without_progress = 0;
    if (start_over) seen = without_divergence(without_lost_checkpoints(seen));
  }
  look_at_starting_points(loaded.campaign, observations, start_over);
  return observations;
}

fs::path folder_with_store(const fs::path& path) {
  require_current_folder(path);
  const fs::path folder = folder_of(path);
  std::error_code unreadable;
  if (!fs::exists(path, unreadable))
    throw BadInput(path.string(), {{"", "there is no such file", "a campaign file, or its folder"}});
  if (!fs::exists(store_path(folder), unreadable)) {
    throw BadInput(path.string(), {{"", "no results store there (" + store_path(folder).string() + ")",
                                    "the folder of a campaign that has been run"}});
  }
  return folder;
}

}  // namespace softwall::campaign
