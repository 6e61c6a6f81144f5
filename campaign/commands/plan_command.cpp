#include <iostream>
#include <map>

#include <nlohmann/json.hpp>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/core/estimate.hpp"
#include "campaign/core/eta.hpp"
#include "campaign/core/plan.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/runner/wording.hpp"
#include "campaign/store/result_table.hpp"

namespace softwall::campaign {
namespace {

struct PlannedCase {
  const CampaignCase* one;
  Decision decision;
  Estimate cost;
};

std::vector<PlannedCase> plan_all(const LoadedCampaign& loaded) {
  const auto observations = observe_all(loaded.campaign, loaded.folder);
  const auto decisions = decide(loaded.campaign, observations);
  std::vector<PlannedCase> planned;
  for (std::size_t i = 0; i < loaded.campaign.cases.size(); ++i) {
    const CampaignCase& one = loaded.campaign.cases[i];
    const double ns = measured_ns_per_cell_step(loaded.campaign, observations, one.definition.physics);
    const bool done = decisions[i].outlook == Outlook::kKept;
    const double reached = done ? one.definition.run.end_time : observations[i].time;
    planned.push_back({&one, decisions[i], estimate(one.definition, ns, reached)});
  }
  return planned;
}

void print_json(const LoadedCampaign& loaded, const std::vector<PlannedCase>& planned) {
  nlohmann::ordered_json cases = nlohmann::json::array();
  for (const auto& [one, decision, cost] : planned) {
    cases.push_back({{"label", one->definition.label},
                     {"case_id", one->definition.id},
                     {"directory", one->directory},
                     {"outlook", to_string(decision.outlook)},
                     {"reason", decision.reason},
                     {"ranks", one->ranks},
                     {"cells", cost.cells},
                     {"steps", cost.steps},
                     {"core_hours", cost.core_hours}});
  }
  const nlohmann::ordered_json plan = {{"campaign", loaded.campaign.name}, {"cases", cases}};
  std::cout << plan.dump(2) << std::endl;
}

void print_text(const LoadedCampaign& loaded, const std::vector<PlannedCase>& planned) {
  ResultTable table{{"case", "plan", "why", "ranks", "cells", "steps", "core-hours"}, {}};
  std::map<std::string, int> counts;
  double core_hours = 0;
  for (const auto& [one, decision, cost] : planned) {
    ++counts[to_string(decision.outlook)];
    core_hours += cost.core_hours;
    table.rows.push_back({one->definition.label, to_string(decision.outlook), decision.reason,
                          std::int64_t{one->ranks}, whole_number(cost.cells), whole_number(cost.steps),
                          short_number(cost.core_hours)});
  }
  write_table(std::cout, table, TableFormat::kText);
  std::cout << "\n" << loaded.campaign.name << ": " << planned.size() << " cases";
  for (const auto& [outlook, number] : counts) std::cout << ", " << number << " " << outlook;
  std::cout << "; about " << short_number(core_hours) << " core-hours to do." << std::endl;
}

}  // namespace

ExitStatus show_plan(const std::filesystem::path& path, bool json) {
  const LoadedCampaign loaded = load_campaign(path);
  const auto planned = plan_all(loaded);
  json ? print_json(loaded, planned) : print_text(loaded, planned);
  return ExitStatus::kDone;
}

}  // namespace softwall::campaign
