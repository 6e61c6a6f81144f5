#include <iostream>
#include <optional>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/left_behind.hpp"
#include "campaign/commands/preflight.hpp"
#include "campaign/core/words.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/left_over.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/removed_directories.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/store/store.hpp"
#include "campaign/store/text_width.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

void print_others(const LoadedCampaign& loaded, const BesideTheCampaign& beside) {
  for (const auto& [file, cases] : beside.of_others)
    std::cout << "Kept for " << printable(file) << ", which asks for them: " << counted(cases, "case")
              << ".\n";
  for (const std::string& file : beside.unreadable)
    std::cout << printable(file) << " cannot be read: before that is mended nothing is removed.\n";
  for (const std::string& directory : directories_without_a_case(loaded.campaign, loaded.folder))
    std::cout << printable(directory)
              << ": without a case.json that can be read, so that nobody knows whose it is; kept.\n";
}

void list(const LoadedCampaign& loaded, const BesideTheCampaign& beside) {
  print_left_behind(std::cout, loaded, beside.cases);
  const auto being_removed = unfinished_removals(loaded.folder);
  for (const auto& rest : being_removed)
    std::cout << printable(rest.filename().string()) << ": the rest of a case that was being removed.\n";
  if (beside.cases.empty() && being_removed.empty())
    std::cout << "Nothing is left over from earlier versions of the campaign file.\n";
  print_others(loaded, beside);
}

void require_that_others_can_be_read(const LoadedCampaign& loaded, const BesideTheCampaign& beside) {
  std::vector<Mistake> mistakes;
  for (const std::string& file : beside.unreadable)
    mistakes.push_back({file, "a campaign file that cannot be read: what it asks for would be removed",
                        "a sound one, or none in this folder"});
  if (!beside.cases.empty() && !mistakes.empty()) throw BadInput(loaded.folder.string(), mistakes);
}

void require_no_solver_in(const LoadedCampaign& loaded, const std::vector<LeftBehind>& cases) {
  std::vector<RunFiles> runs;
  for (const LeftBehind& one : cases) runs.push_back({loaded.folder / one.directory});
  const auto busy = occupied(runs, *make_launcher(loaded.campaign.execution));
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (busy[i]) throw std::runtime_error("a solver works in " + runs[i].directory.string());
}

/// Each leaves the store first: a row without a directory would be a result that nobody can look into.
void remove(const LoadedCampaign& loaded, const std::vector<LeftBehind>& cases) {
  if (cases.empty()) return;
  require_no_solver_in(loaded, cases);
  std::optional<Store> store;
  if (std::filesystem::exists(store_path(loaded.folder))) {
    store = Store::open(loaded.folder, OpenMode::kReadWrite);
    store->record_campaign(loaded.campaign);  // it may have been edited since the last run
  }
  for (const LeftBehind& one : cases) {
    if (store) store->forget(one.case_id);
    remove_run_directory(loaded.folder / one.directory);
    std::cout << "removed " << printable(one.directory) << "\n";
  }
}

}  // namespace

ExitStatus clean_campaign(const std::filesystem::path& path, bool really) {
  const LoadedCampaign loaded = load_campaign(path);
  if (!really) {
    list(loaded, beside_the_campaign(loaded));
    return ExitStatus::kDone;
  }
  require_writable(loaded.folder);
  const CampaignLock lock(loaded.folder);
  const BesideTheCampaign beside = beside_the_campaign(loaded);
  require_that_others_can_be_read(loaded, beside);
  for (const auto& rest : unfinished_removals(loaded.folder)) std::filesystem::remove_all(rest);
  remove(loaded, beside.cases);
  std::cout << counted(std::ssize(beside.cases), "case") << " removed.\n";
  print_others(loaded, beside);
  return ExitStatus::kDone;
}

}  // namespace softwall::campaign
