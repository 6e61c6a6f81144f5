#include <algorithm>
#include <iostream>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/preflight.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/store/import_results.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {
namespace {

/// Out of the way, never removed: with the two files that SQLite may keep beside it.
void set_old_store_aside(const std::filesystem::path& store) {
  if (!std::filesystem::exists(store)) return;
  std::string time = utc_now();
  std::ranges::replace(time, ':', '-');
  const std::filesystem::path old = store.string() + "." + time;
  for (const std::string suffix : {"", "-wal", "-shm"}) {
    const std::filesystem::path file = store.string() + suffix;
    if (std::filesystem::exists(file)) std::filesystem::rename(file, old.string() + suffix);
  }
  std::cerr << "The old store is now " << old.string() << "\n";
}

}  // namespace

ExitStatus rebuild_store(const std::filesystem::path& path) {
  const LoadedCampaign loaded = load_campaign(path);
  require_writable(loaded.folder);
  const CampaignLock lock(loaded.folder);
  set_old_store_aside(store_path(loaded.folder));
  Store store = Store::open(loaded.folder, OpenMode::kCreate);
  store.record_campaign(loaded.campaign);
  const auto launcher = make_launcher(loaded.campaign.execution.launcher);
  int results = 0;
  int without = 0;
  for (const CampaignCase& one : loaded.campaign.cases) {
    const RunFiles run = run_files(loaded.folder, one);
    import_history(store, one, run, *launcher);
    if (observe(one, run, *launcher).state != CaseState::kFinished) continue;
    try {
      results += import_result(store, one, run) ? 1 : 0;
    } catch (const SqliteError&) {
      throw;
    } catch (const std::runtime_error& error) {
      ++without;
      std::cerr << one.definition.label << ": no result: " << error.what() << "\n";
    }
  }
  std::cerr << "Made " << store_path(loaded.folder).string()
            << " from the run directories: " << loaded.campaign.cases.size() << " cases, " << results
            << " results.\n";
  return without == 0 ? ExitStatus::kDone : ExitStatus::kFailedCases;
}

}  // namespace softwall::campaign
