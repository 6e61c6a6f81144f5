#include "campaign/commands/campaign_folder.hpp"

#include "campaign/core/campaign_file.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/case_directories.hpp"
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

fs::path campaign_file(const fs::path& path) {
  if (!is_folder(path)) return path;
  std::error_code unreadable;
  if (!fs::exists(path / kCampaignFile, unreadable)) {
    throw BadInput(path.string(),
                   {{"", "a folder without a campaign.json", "a campaign file, or its folder"}});
  }
  return path / kCampaignFile;
}

/// The folder without symbolic links, because a solver that works there knows it by this name.
fs::path folder_of(const fs::path& path) {
  const fs::path folder = is_folder(path) ? path : fs::absolute(path).parent_path();
  return fs::weakly_canonical(folder);
}

}  // namespace

LoadedCampaign load_campaign(const fs::path& path) {
  require_current_folder(path);
  const fs::path file = campaign_file(path);
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
    if (start_over) seen = without_lost_checkpoints(seen);
  }
  return observations;
}

fs::path folder_with_store(const fs::path& path) {
  require_current_folder(path);
  const fs::path folder = folder_of(path);
  std::error_code unreadable;
  if (!fs::exists(store_path(folder), unreadable)) {
    throw BadInput(path.string(), {{"", "no results store there (" + store_path(folder).string() + ")",
                                    "the folder of a campaign that has been run"}});
  }
  return folder;
}

}  // namespace softwall::campaign
