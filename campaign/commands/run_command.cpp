#include <iostream>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/preflight.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/runner/progress.hpp"
#include "campaign/runner/runner.hpp"
#include "campaign/store/query.hpp"

namespace softwall::campaign {
namespace {

std::string count(std::size_t number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

void print_results(const std::filesystem::path& folder) {
  write_table(std::cout,
              run_query(folder,
                        "SELECT label AS \"case\", state, re_tau_w, re_tau, u_max, y_max, delta_u_plus,"
                        " delta_max, delta_rms FROM results"),
              TableFormat::kText);
  std::cout << std::flush;
}

/// What is done, what is not and why, and what to do next.
void print_report(const RunnerReport& report, const std::filesystem::path& folder, const std::string& name) {
  const auto explain = [](const std::vector<RunnerReport::Trouble>& troubles) {
    for (const auto& trouble : troubles) std::cerr << "  " << trouble.label << ": " << trouble.reason << "\n";
  };
  std::cerr << "\n"
            << name << ": " << report.finished << " of " << count(report.cases, "case") << " finished.\n";
  if (!report.failed.empty()) {
    std::cerr << count(report.failed.size(), "case") << " failed:\n";
    explain(report.failed);
    std::cerr << "The log of a case is solver.log in its folder below " << (folder / "cases").string()
              << ".\n";
  }
  if (!report.unfinished.empty()) {
    std::cerr << count(report.unfinished.size(), "case") << " not finished:\n";
    explain(report.unfinished);
    std::cerr << "To go on:  softwall resume " << folder.string() << "\n";
  }
  std::cerr << "Results store: " << store_path(folder).string() << "\n";
  if (report.finished > 0) std::cerr << "The paper's tables:  softwall table " << folder.string() << "\n";
}

ExitStatus status_of(const RunnerReport& report) {
  if (!report.unfinished.empty()) return ExitStatus::kUnfinished;
  return report.failed.empty() ? ExitStatus::kDone : ExitStatus::kFailedCases;
}

}  // namespace

ExitStatus run_campaign(const std::filesystem::path& path, const RunOptions& options) {
  const LoadedCampaign loaded = load_campaign(path);
  require_writable(loaded.folder);
  const CampaignLock lock(loaded.folder);
  const auto solver = find_solver();
  require_precisions(loaded.campaign, solver);
  const auto launcher = make_launcher(loaded.campaign.execution.launcher);
  launcher->prepare(solver);
  require_disk_space(loaded.campaign, loaded.folder);

  RunnerReport report;
  Signals
      signals;  // also while the report is printed: a reader that has gone away must not change our status
  {
    Progress progress(loaded.folder / "manager.log");
    Store store = Store::open(loaded.folder, OpenMode::kCreate);
    progress.event(loaded.campaign.name + ": " + count(loaded.campaign.cases.size(), "case") + " in " +
                   loaded.folder.string());
    RunnerOptions runner_options;
    runner_options.stall_seconds = options.stall_minutes * 60;
    report =
        Runner(loaded.campaign, loaded.folder, {*launcher, store, progress, signals}, runner_options).run();
  }
  if (report.finished > 0) print_results(loaded.folder);
  print_report(report, loaded.folder, loaded.campaign.name);
  return status_of(report);
}

}  // namespace softwall::campaign
