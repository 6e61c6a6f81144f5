#include <iostream>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/left_behind.hpp"
#include "campaign/commands/preflight.hpp"
#include "campaign/core/words.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/store/store.hpp"
#include "campaign/store/text_width.hpp"

namespace softwall::campaign {
namespace {

/// The store learns what belongs to the campaign now, for it may have been edited since the last run.
void record_campaign(const LoadedCampaign& loaded) {
  if (!std::filesystem::exists(store_path(loaded.folder))) return;
  Store::open(loaded.folder, OpenMode::kReadWrite).record_campaign(loaded.campaign);
}

/// The store first: a row without a directory would be a result that nobody can look into.
void remove(const LoadedCampaign& loaded, const LeftBehind& one) {
  const RunFiles run{loaded.folder / one.directory};
  if (is_occupied(run, *make_launcher(loaded.campaign.execution)))
    throw std::runtime_error("a solver works in " + run.directory.string());
  if (std::filesystem::exists(store_path(loaded.folder))) {
    Store store = Store::open(loaded.folder, OpenMode::kReadWrite);
    store.forget(one.case_id);
  }
  std::filesystem::remove_all(run.directory);
}

}  // namespace

ExitStatus clean_campaign(const std::filesystem::path& path, bool really) {
  const LoadedCampaign loaded = load_campaign(path);
  if (!really) {
    const auto cases = left_behind(loaded);
    print_left_behind(std::cout, loaded, cases);
    if (cases.empty()) std::cout << "Nothing is left over from earlier versions of the campaign file.\n";
    return ExitStatus::kDone;
  }
  require_writable(loaded.folder);
  const CampaignLock lock(loaded.folder);
  const auto cases = left_behind(loaded);
  if (!cases.empty()) record_campaign(loaded);
  for (const LeftBehind& one : cases) {
    remove(loaded, one);
    std::cout << "removed " << printable(one.directory) << "\n";
  }
  std::cout << counted(std::ssize(cases), "case") << " removed.\n";
  return ExitStatus::kDone;
}

}  // namespace softwall::campaign
