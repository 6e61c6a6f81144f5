#include "campaign/commands/left_behind.hpp"

#include <algorithm>
#include <map>
#include <ostream>

#include "campaign/commands/other_campaigns.hpp"
#include "campaign/core/words.hpp"
#include "campaign/observe/left_over.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/runner/wording.hpp"
#include "campaign/store/store.hpp"
#include "campaign/store/text_width.hpp"
#include "campaign/system/shell_words.hpp"

namespace softwall::campaign {
namespace {

constexpr std::size_t kMostExplained = 20;  // each is compared with every case of the campaign

std::map<std::string, double> known_core_hours(const std::filesystem::path& folder) {
  try {
    if (!std::filesystem::exists(store_path(folder))) return {};
    return Store::open(folder, OpenMode::kReadOnly).core_hours();
  } catch (const SqliteError&) {
    return {};  // the run directories know of the last attempt
  }
}

double last_core_hours(const RunFiles& run, const std::string& case_id) {
  const auto summary = read_summary(run, case_id);
  return summary ? summary->wall_seconds * summary->ranks / 3600 : 0.0;
}

}  // namespace

BesideTheCampaign beside_the_campaign(const LoadedCampaign& loaded) {
  BesideTheCampaign beside;
  const auto left = left_over_cases(loaded.campaign, loaded.folder);
  if (left.empty()) return beside;
  const OtherCampaigns others = other_campaigns(loaded);
  beside.unreadable = others.unreadable;
  const auto hours = known_core_hours(loaded.folder);
  for (const CampaignCase& one : left) {
    const RunFiles run = run_files(loaded.folder, one);
    const std::string& id = one.definition.id;
    if (const auto other = others.asked_by.find(id); other != others.asked_by.end()) {
      ++beside.of_others[other->second];
      continue;
    }
    const auto known = hours.find(id);
    const bool explained = beside.cases.size() < kMostExplained;
    beside.cases.push_back({.label = one.definition.label,
                            .case_id = id,
                            .directory = one.directory,
                            .state = std::string(word_of(observe_files(one, run).state)),
                            .core_hours = known != hours.end() ? known->second : last_core_hours(run, id),
                            .reason = explained ? why_left_over(one, loaded.campaign) : ""});
  }
  return beside;
}

void print_left_behind(std::ostream& out, const LoadedCampaign& loaded,
                       const std::vector<LeftBehind>& cases) {
  if (cases.empty()) return;
  double core_hours = 0;
  for (const LeftBehind& one : cases) core_hours += one.core_hours;
  out << "\nLeft behind by changes of the campaign file, kept on disk, not in its results: "
      << counted(std::ssize(cases), "case") << " that took " << short_number(core_hours)
      << " core-hours. To remove:  " << softwall_command("clean", loaded.named) << " --remove\n";
  for (std::size_t i = 0; i < std::min(cases.size(), kMostExplained); ++i) {
    const LeftBehind& one = cases[i];
    out << "  " << printable(one.label) << " (" << one.case_id.substr(0, 8) << "): " << one.state << ", "
        << short_number(one.core_hours) << " core-hours" << (one.reason.empty() ? "" : "; ")
        << printable(one.reason) << "\n";
  }
  if (cases.size() > kMostExplained) out << "  and " << cases.size() - kMostExplained << " more\n";
}

}  // namespace softwall::campaign
