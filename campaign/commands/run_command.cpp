#include <algorithm>
#include <iostream>
#include <optional>
#include <span>
#include <system_error>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/preflight.hpp"
#include "campaign/core/words.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/left_over.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/runner/progress.hpp"
#include "campaign/runner/runner.hpp"
#include "campaign/store/import_directories.hpp"
#include "campaign/store/text_width.hpp"
#include "campaign/system/shell_words.hpp"
#include "campaign/tables/closing_table.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {
namespace {

/// The results with as many digits as their 95 % intervals call for.
void print_results(const std::filesystem::path& folder) {
  Connection store = open_store_file(folder, OpenMode::kReadOnly);
  write_closing_table(std::cout, store);
  std::cout << std::flush;
}

/// The first ones: the reason of most is that of one, and softwall status has them all.
void explain(const std::vector<RunnerReport::Trouble>& troubles, const LoadedCampaign& loaded) {
  constexpr std::size_t kMostExplained = 10;
  for (const auto& trouble : std::span(troubles).first(std::min(troubles.size(), kMostExplained))) {
    std::cerr << "  " << trouble.label << ": " << printable(trouble.reason) << "\n";
    const auto log = RunFiles{loaded.folder / trouble.directory}.log();
    if (std::filesystem::exists(log)) std::cerr << "    its log: " << printable(log.string()) << "\n";
  }
  if (troubles.size() > kMostExplained)
    std::cerr << "  and " << troubles.size() - kMostExplained
              << " more:  " << softwall_command("status", loaded.named) << "\n";
}

/// What is done, what is not and why, and what to do next.
/// start_over: the run was asked for it, and whoever goes on has to ask again.
void print_report(const RunnerReport& report, const LoadedCampaign& loaded, bool start_over) {
  const auto& folder = loaded.folder;
  std::cerr << "\n"
            << printable(loaded.campaign.name) << ": " << report.finished << " of "
            << counted(report.cases, "case") << " finished.\n";
  if (!report.failed.empty()) {
    std::cerr << counted(report.failed.size(), "case") << " failed:\n";
    explain(report.failed, loaded);
  }
  if (!report.unfinished.empty()) {
    std::cerr << counted(report.unfinished.size(), "case") << " not finished:\n";
    explain(report.unfinished, loaded);
    std::cerr << "To go on:  " << softwall_command("resume", loaded.named)
              << (start_over ? " --start-over" : "") << "\n";
  }
  std::cerr << "Results store: " << printable(store_path(folder).string()) << "\n";
  if (report.finished > 0) std::cerr << "The paper's tables:  " << softwall_command("table", folder) << "\n";
}

ExitStatus status_of(const RunnerReport& report) {
  if (!report.unfinished.empty()) return ExitStatus::kUnfinished;
  return report.failed.empty() ? ExitStatus::kDone : ExitStatus::kFailedCases;
}

/// What is left of earlier versions of the campaign file goes into a store that knows nothing yet.
void record_left_over(Store& store, const std::filesystem::path& folder,
                      const std::vector<CampaignCase>& left, const Launcher& launcher) {
  if (left.empty() || !store.all_cases().empty()) return;
  Transaction together(store.connection());
  store.record_left_over(left);
  import_directories(store, left, folder, launcher);
  together.commit();
}

/// damage: what was wrong with the store that was set aside before; empty: none was. signals: made when
/// nothing can be refused any more; a stop that was asked for counts for all that comes after it.
ExitStatus run_with_store(const LoadedCampaign& loaded, const RunOptions& options, const std::string& damage,
                          std::optional<Signals>& signals) {
  const auto launcher = make_launcher(loaded.campaign.execution);
  const Preflight ready =
      preflight(loaded, observe_for_run(loaded, *launcher, options.start_over), *launcher);
  require_nothing_in_the_way(ready, loaded.folder);

  RunnerReport report;
  if (!signals) signals.emplace();
  {
    Progress progress(loaded.folder / "manager.log");
    if (!damage.empty()) progress.event(damage, Progress::Kind::kBad);
    Store store = Store::open(loaded.folder, OpenMode::kCreate);
    progress.event(loaded.campaign.name + ": " + counted(loaded.campaign.cases.size(), "case") + " in " +
                   loaded.folder.string());
    if (const auto left = left_over_cases(loaded.campaign, loaded.folder); !left.empty()) {
      progress.event(counted(left.size(), "case") + " that this campaign file does not ask for left out; " +
                     softwall_command("clean", loaded.named) + " lists them");
      record_left_over(store, loaded.folder, left, *launcher);
    }
    RunnerOptions runner_options;
    runner_options.stall_seconds = options.stall_minutes * 60;
    runner_options.start_over = options.start_over;
    runner_options.no_programs = ready.no_programs;
    report =
        Runner(loaded.campaign, loaded.folder, {*launcher, store, progress, *signals}, runner_options).run();
  }
  try {
    if (report.finished > 0) print_results(loaded.folder);
  } catch (const SqliteError& error) {
    std::cerr << "softwall: " << printable_lines(error.what()) << "\n";  // the report says how the run ended
  }
  print_report(report, loaded, options.start_over);
  return status_of(report);
}

/// Whoever has just written it may not have waited for the disk: after a power loss there would be results,
/// and no campaign. No more than a precaution, so that failing is no error.
void keep_campaign_file(const LoadedCampaign& loaded) {
  try {
    sync_file(loaded.file);
  } catch (const std::system_error&) {
    return;
  }
}

}  // namespace

/// A store that is damaged, also while the campaign runs, costs nobody a step: it is set aside, and made
/// again from the run directories, which are the truth.
ExitStatus run_campaign(const std::filesystem::path& path, const RunOptions& options) {
  const LoadedCampaign loaded = load_campaign(path);
  require_writable(loaded.folder);
  CampaignLock lock(loaded.folder);
  keep_campaign_file(loaded);
  sweep_unfinished_stores(loaded.folder);
  std::string damage;
  std::optional<Signals> signals;  // also while the report is printed: a reader that has gone away must not
                                   // change our status
  try {
    return run_with_store(loaded, options, damage, signals);
  } catch (const BadInput&) {
    lock.leave_no_trace();
    throw;
  } catch (const SqliteError& error) {
    if (!error.is_damage()) throw;
    damage = error.what();
  }
  const auto old = set_store_aside(loaded.folder);
  damage += "; the store is made again from the run directories, the old one is now " + old.string();
  return run_with_store(loaded, options, damage, signals);
}

}  // namespace softwall::campaign
