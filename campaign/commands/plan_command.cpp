#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/failure_report.hpp"
#include "campaign/commands/left_behind.hpp"
#include "campaign/commands/preflight.hpp"
#include "campaign/core/estimate.hpp"
#include "campaign/core/eta.hpp"
#include "campaign/core/machine.hpp"
#include "campaign/core/plan.hpp"
#include "campaign/core/words.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/runner/wording.hpp"
#include "campaign/store/result_table.hpp"
#include "campaign/store/text_width.hpp"
#include "campaign/system/clock.hpp"

namespace softwall::campaign {
namespace {

struct PlannedCase {
  const CampaignCase* one;
  Decision decision;
  Estimate cost;
  std::optional<int> job_minutes;  ///< that its next job would ask for; empty: none, or the partition's limit
};

struct PlannedCampaign {
  std::vector<PlannedCase> cases;
  Preflight ready;
  double wall_seconds = 0;
  std::vector<LeftBehind> left_behind;
};

std::optional<int> job_minutes(const Launcher& launcher, const CampaignCase& one, const Observation& seen,
                               Outlook outlook) {
  LaunchRequest request;
  request.needed_seconds = measured_seconds_left(one, seen);
  return may_start(outlook) ? launcher.job_minutes(request) : std::nullopt;
}

PlannedCampaign plan_all(const LoadedCampaign& loaded) {
  const Campaign& campaign = loaded.campaign;
  const auto launcher = make_launcher(campaign.execution);
  const auto observations = observe_for_run(loaded, *launcher);
  const auto decisions = decide(campaign, observations);
  const MeasuredSpeed speed(campaign, observations);
  PlannedCampaign planned;
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const CampaignCase& one = campaign.cases[i];
    const double ns = speed.ns_per_cell_step(one.definition.physics);
    const bool done = decisions[i].outlook == Outlook::kKept;
    const double reached = done ? one.definition.run.end_time : observations[i].time;
    planned.cases.push_back({&one, decisions[i], estimate(one.definition, ns, reached), std::nullopt});
  }
  planned.ready = preflight(loaded, observations, *launcher);
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const std::string& why = planned.ready.blocked[i];
    if (!why.empty()) planned.cases[i].decision = {campaign.cases[i].definition.id, Outlook::kBlocked, why};
    planned.cases[i].job_minutes =
        job_minutes(*launcher, campaign.cases[i], observations[i], planned.cases[i].decision.outlook);
  }
  planned.wall_seconds = remaining_seconds(campaign, observations, {}, campaign.execution.cores);
  planned.left_behind = beside_the_campaign(loaded).cases;
  return planned;
}

using Json = nlohmann::ordered_json;

Json json_of(const PlannedCase& planned) {
  const auto& [one, decision, cost, minutes] = planned;
  return {{"label", one->definition.label},
          {"case_id", one->definition.id},
          {"directory", one->directory},
          {"starts_from", one->precursor_id},
          {"outlook", to_string(decision.outlook)},
          {"reason", decision.reason},
          {"ranks", one->ranks},
          {"cells", cost.cells},
          {"steps", cost.steps},
          {"core_hours", cost.core_hours},
          {"job_minutes", minutes ? Json(*minutes) : Json()}};
}

Json json_of(const LeftBehind& one) {
  return {{"label", one.label}, {"case_id", one.case_id},       {"directory", one.directory},
          {"state", one.state}, {"core_hours", one.core_hours}, {"reason", one.reason}};
}

/// An array, also of none.
template <class Item>
Json json_of_all(const std::vector<Item>& items) {
  Json all = Json::array();
  for (const Item& item : items) all.push_back(json_of(item));
  return all;
}

void print_json(const LoadedCampaign& loaded, const PlannedCampaign& planned) {
  const int cores = loaded.campaign.execution.cores;
  const Json plan = {{"campaign", loaded.campaign.name},
                     {"until", describe(loaded.campaign.until)},
                     {"cores", cores == kUnlimitedCores ? Json() : Json(cores)},
                     {"wall_seconds", planned.wall_seconds},
                     {"disk_bytes", planned.ready.disk.bytes()},
                     {"checkpoint_bytes", planned.ready.disk.checkpoint_bytes},
                     {"snapshot_bytes", planned.ready.disk.snapshot_bytes},
                     {"snapshots", planned.ready.disk.snapshots},
                     {"film_bytes", planned.ready.disk.film_bytes},
                     {"film_moments", planned.ready.disk.film_moments},
                     {"disk_free_bytes", planned.ready.disk_free_bytes},
                     {"memory_bytes", planned.ready.memory_bytes},
                     {"machine_memory_bytes", planned.ready.machine_memory_bytes},
                     {"refused", json_of_mistakes(planned.ready.mistakes)},
                     {"cases", json_of_all(planned.cases)},
                     {"left_behind", json_of_all(planned.left_behind)}};
  std::cout << plan.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

/// "On 2 cores of this machine: about 3 min; memory 1 GB of 8 GB"
std::string where_and_how_long(const Execution& execution, const PlannedCampaign& planned) {
  const int cores = execution.cores;
  const std::string time = ": " + describe_about(planned.wall_seconds);
  const std::string those = counted(cores, "core");
  const int there = planned.ready.machine_cores;
  const std::string of_how_many = cores > there ? " (it has " + std::to_string(there) + ")" : "";
  if (planned.ready.machine_memory_bytes > 0)
    return "On " + those + " of this machine" + of_how_many + time + "; memory " +
           gigabytes(planned.ready.memory_bytes) + " of " + gigabytes(planned.ready.machine_memory_bytes);
  const std::string most = cores == kUnlimitedCores ? "all of them at once" : those + " at once";
  const int together = execution.slurm.cases_per_job;
  const std::string jobs = together > 1 ? ", up to " + counted(together, "case") + " a job" : "";
  return "By " + execution.launcher + ", " + most + jobs + " and without waiting" + time +
         "; memory together " + gigabytes(planned.ready.memory_bytes);
}

void print_text(const LoadedCampaign& loaded, const PlannedCampaign& planned) {
  ResultTable table{{"case", "plan", "why", "ranks", "cells", "steps", "core-hours"}, {}};
  const bool with_jobs =
      std::ranges::any_of(planned.cases, [](const auto& one) { return bool(one.job_minutes); });
  if (with_jobs) table.columns.emplace_back("minutes a job");
  std::map<std::string, int> counts;
  double core_hours = 0;
  for (const auto& [one, decision, cost, minutes] : planned.cases) {
    ++counts[to_string(decision.outlook)];
    if (decision.outlook != Outlook::kBlocked) core_hours += cost.core_hours;
    table.rows.push_back({one->definition.label, to_string(decision.outlook), decision.reason,
                          std::int64_t{one->ranks}, whole_number(cost.cells), whole_number(cost.steps),
                          short_number(cost.core_hours)});
    if (with_jobs) table.rows.back().push_back(minutes ? Cell(std::int64_t{*minutes}) : Cell());
  }
  write_table(std::cout, table, TableFormat::kText);
  std::cout << "\n" << printable(loaded.campaign.name) << ": " << counted(std::ssize(planned.cases), "case");
  for (const auto& [outlook, number] : counts) std::cout << ", " << number << " " << outlook;
  std::cout << "; about " << short_number(core_hours) << " core-hours to do.\n"
            << where_and_how_long(loaded.campaign.execution, planned) << "; disk for "
            << words_of(planned.ready.disk) << ", free " << gigabytes(planned.ready.disk_free_bytes) << ".\n";
  if (loaded.campaign.start_from)
    std::cout << "Cases start one from the other, from the " << words_of(*loaded.campaign.start_from)
              << " on: those of a line run one after the other.\n";
  if (!loaded.campaign.until.empty())
    std::cout << "A case ends before its end time once it has " << describe(loaded.campaign.until)
              << "; this is what it takes otherwise.\n";
  print_left_behind(std::cout, loaded, planned.left_behind);
  std::cout << std::flush;
}

}  // namespace

ExitStatus show_plan(const std::filesystem::path& path, bool json) {
  const LoadedCampaign loaded = load_campaign(path);
  const PlannedCampaign planned = plan_all(loaded);
  json ? print_json(loaded, planned) : print_text(loaded, planned);
  // In these words run would refuse; in JSON they are "refused".
  if (!json && !planned.ready.mistakes.empty())
    std::cerr << printable_lines(refusal(planned.ready, loaded.folder).what()) << "\n";
  return ExitStatus::kDone;
}

}  // namespace softwall::campaign
