#include <unistd.h>

#include <iostream>
#include <map>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/preflight.hpp"
#include "campaign/core/words.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/left_over.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/store/import_directories.hpp"
#include "campaign/store/store_schema.hpp"
#include "campaign/store/text_width.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {
namespace {

/// Attempts by case id, from the store that is about to be replaced: only the newest ones of a run directory
/// written by an earlier version leave a trace there. Whatever of them can still be read.
std::map<std::string, std::vector<PastAttempt>> attempts_in_old_store(
    const std::filesystem::path& folder, const std::vector<CampaignCase>& cases) {
  std::map<std::string, std::vector<PastAttempt>> attempts;
  if (!std::filesystem::exists(store_path(folder))) return attempts;
  try {
    const Store store = Store::open(folder, OpenMode::kReadOnly);
    for (const CampaignCase& one : cases)
      attempts[one.definition.id] = store.past_attempts(one.definition.id);
  } catch (const SqliteError& error) {
    if (is_of_newer_format(error)) throw;  // an older store must not take its place
    std::cerr << "Nothing can be read from the old store: " << printable_lines(error.what()) << "\n";
  }
  return attempts;
}

/// The window that a case of an earlier version of the campaign file was last averaged over stands in the old
/// store alone.
void keep_windows(const std::filesystem::path& folder, std::vector<CampaignCase>& left_over) {
  if (left_over.empty() || !std::filesystem::exists(store_path(folder))) return;
  try {
    const auto origins = Store::open(folder, OpenMode::kReadOnly).result_origins();
    for (CampaignCase& one : left_over) {
      const auto origin = origins.find(one.definition.id);
      if (origin != origins.end()) one.window_start = origin->second.window_asked.value_or(0);
    }
  } catch (const SqliteError&) {
    return;  // told where its attempts are read
  }
}

/// A folder beside the old store for the new one, until it is complete: a full disk must not leave none.
class Workshop {
 public:
  explicit Workshop(const std::filesystem::path& folder)
      : place_(folder / (kRebuildFolder + std::to_string(getpid()))) {
    std::filesystem::remove_all(place_);
    std::filesystem::create_directory(place_);
  }
  ~Workshop() {
    std::error_code ignored;
    std::filesystem::remove_all(place_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  [[nodiscard]] const std::filesystem::path& place() const { return place_; }

 private:
  std::filesystem::path place_;
};

ImportedDirectories fill(Store& store, const LoadedCampaign& loaded,
                         const std::vector<CampaignCase>& left_over) {
  const auto launcher = make_launcher(loaded.campaign.execution);
  std::vector<CampaignCase> all = loaded.campaign.cases;
  all.insert(all.end(), left_over.begin(), left_over.end());
  const auto past = attempts_in_old_store(loaded.folder, all);
  Transaction together(store.connection());
  store.record_campaign(loaded.campaign);
  store.record_left_over(left_over);
  for (const auto& [id, attempts] : past) {
    for (const PastAttempt& each : attempts) store.restore_attempt(id, each.attempt, each.start, each.end);
  }
  auto imported = import_directories(store, all, loaded.folder, *launcher);
  for (const CampaignCase& one : loaded.campaign.cases) {
    const auto known = past.find(one.definition.id);
    if (known == past.end() || known->second.empty() ||
        std::filesystem::exists(loaded.folder / one.directory))
      continue;
    imported.troubles.push_back(
        one.definition.label +
        ": its run directory is missing; what is known of it is in the old store alone");
  }
  store.mark_stale(build_info().version);
  together.commit();
  return imported;
}

}  // namespace

ExitStatus rebuild_store(const std::filesystem::path& path) {
  const LoadedCampaign loaded = load_campaign(path);
  require_writable(loaded.folder);
  const CampaignLock lock(loaded.folder);
  sweep_unfinished_stores(loaded.folder);
  auto left_over = left_over_cases(loaded.campaign, loaded.folder);
  keep_windows(loaded.folder, left_over);
  const Workshop workshop(loaded.folder);
  ImportedDirectories imported;
  {
    Store store = Store::open(workshop.place(), OpenMode::kCreate);
    imported = fill(store, loaded, left_over);
    store.connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");
  }
  for (const std::string& trouble : imported.troubles) std::cerr << printable_lines(trouble) << "\n";
  if (const auto old = set_store_aside(loaded.folder); !old.empty())
    std::cerr << "The old store is now " << printable(old.string()) << "\n";
  publish_file(store_path(workshop.place()), store_path(loaded.folder));
  std::cerr << "Made " << printable(store_path(loaded.folder).string())
            << " from the run directories: " << counted(std::ssize(loaded.campaign.cases), "case") << ", "
            << counted(imported.results, "result")
            << (left_over.empty() ? "" : ", " + counted(std::ssize(left_over), "left-over case")) << ".\n";
  return imported.troubles.empty() ? ExitStatus::kDone : ExitStatus::kFailedCases;
}

}  // namespace softwall::campaign
