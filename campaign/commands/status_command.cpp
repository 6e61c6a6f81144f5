#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <thread>

#include <nlohmann/json.hpp>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/core/eta.hpp"
#include "campaign/core/plan.hpp"
#include "campaign/core/words.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/runner/wording.hpp"
#include "campaign/store/import_results.hpp"
#include "campaign/store/result_table.hpp"
#include "campaign/store/store.hpp"
#include "campaign/system/clock.hpp"
#include "campaign/system/shell_words.hpp"
#include "solver/case/time_comparison.hpp"

namespace softwall::campaign {
namespace {

struct Snapshot {
  std::vector<Observation> observations;
  std::map<std::string, Status> working;
  std::optional<std::string> owner;  ///< the softwall that runs the campaign
  bool owner_is_unknown = false;     ///< there may be one
  double seconds_left = 0;
};

Snapshot look(const LoadedCampaign& loaded) {
  Snapshot now;
  now.owner = living_owner(loaded.folder);
  now.owner_is_unknown = owner_is_unknown(loaded.folder);
  const auto launcher = make_launcher(loaded.campaign.execution);
  const bool nobody_runs_it = !now.owner && !now.owner_is_unknown;  // who does so next grants another try
  now.observations =
      nobody_runs_it ? observe_for_run(loaded, *launcher) : observe_with_history(loaded, *launcher);
  for (std::size_t i = 0; i < now.observations.size(); ++i) {
    const CampaignCase& one = loaded.campaign.cases[i];
    if (const auto status = report_of_work(run_files(loaded.folder, one), now.observations[i]))
      now.working[one.definition.id] = *status;
  }
  now.seconds_left =
      remaining_seconds(loaded.campaign, now.observations, now.working, loaded.campaign.execution.cores);
  return now;
}

/// Time and step that a case has reached, by its checkpoints or, while it works, by its own report.
std::pair<double, std::int64_t> reached(const Snapshot& now, const Observation& seen) {
  const auto status = now.working.find(seen.case_id);
  if (status == now.working.end()) return {seen.time, seen.step};
  return {status->second.time, status->second.step};
}

/// What a case is at: its state, or, of one that has been started, whether its attempt waits, works or cannot
/// be asked about.
std::string state_words(const Observation& seen) {
  const bool started = seen.running && seen.presence != Presence::kGone;
  return std::string(started ? word_of(seen.presence) : word_of(seen.state));
}

/// What would become of each case now, and why: "waiting: for G=2".
std::vector<std::string> reasons(const LoadedCampaign& loaded, const Snapshot& now) {
  std::vector<std::string> told;
  for (const Decision& decision : decide(loaded.campaign, now.observations))
    told.push_back(to_string(decision.outlook) + ": " + decision.reason);
  return told;
}

void print_json(const LoadedCampaign& loaded, const Snapshot& now, bool why) {
  const auto told = why ? reasons(loaded, now) : std::vector<std::string>();
  nlohmann::ordered_json cases = nlohmann::json::array();
  for (std::size_t i = 0; i < now.observations.size(); ++i) {
    const CampaignCase& one = loaded.campaign.cases[i];
    const Observation& seen = now.observations[i];
    const auto [time, step] = reached(now, seen);
    cases.push_back({{"label", one.definition.label},
                     {"case_id", one.definition.id},
                     {"directory", one.directory},
                     {"state", state_words(seen)},
                     {"reason", seen.reason},
                     {"time", time},
                     {"end_time", seen.end_time},
                     {"step", step},
                     {"attempts", seen.attempts},
                     {"seconds_per_step", seen.seconds_per_step}});
    if (why) cases.back()["why"] = told[i];
  }
  const nlohmann::ordered_json status = {
      {"campaign", loaded.campaign.name},
      {"runner", now.owner ? nlohmann::json(*now.owner) : nlohmann::json()},
      {"runner_known", !now.owner_is_unknown},
      {"seconds_left", now.seconds_left},
      {"cases", cases}};
  std::cout << status.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

/// Which cases a person looks for first.
int rank_of(CaseState state) {
  switch (state) {
    case CaseState::kRunning:
      return 0;
    case CaseState::kFailed:
    case CaseState::kDiverged:
      return 1;
    case CaseState::kInterrupted:
      return 2;
    case CaseState::kNew:
      return 3;
    case CaseState::kFinished:
      break;
  }
  return 4;
}

/// At most so many cases, those that matter most now, in the order of the campaign.
std::vector<std::size_t> chosen_cases(const std::vector<Observation>& observations, std::size_t most) {
  std::vector<std::size_t> chosen(observations.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  if (chosen.size() <= most) return chosen;
  std::ranges::stable_sort(chosen, {}, [&](std::size_t i) { return rank_of(observations[i].state); });
  chosen.resize(most);
  std::ranges::sort(chosen);
  return chosen;
}

/// What a person sees of the cases.
struct TextLayout {
  bool why = false;  ///< what would become of each, in place of how its last attempt ended
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< cases
};

std::string remark_on(const Observation& seen) {
  if (!seen.running && !seen.needs_person.empty()) return seen.needs_person;
  return seen.state == CaseState::kFinished && !seen.early ? std::string() : seen.reason;
}

void print_text(const LoadedCampaign& loaded, const Snapshot& now, const TextLayout& layout) {
  ResultTable table{{"case", "state", "t", "of", "%", "step", "attempts", layout.why ? "why" : "remark"}, {}};
  const auto told = layout.why ? reasons(loaded, now) : std::vector<std::string>();
  const auto chosen = chosen_cases(now.observations, layout.most);
  for (const std::size_t i : chosen) {
    const Observation& seen = now.observations[i];
    const auto [time, step] = reached(now, seen);
    table.rows.push_back({loaded.campaign.cases[i].definition.label, state_words(seen), short_number(time),
                          short_number(seen.end_time),
                          static_cast<std::int64_t>(percent_done(time, seen.end_time)), step,
                          std::int64_t{seen.attempts}, layout.why ? told[i] : remark_on(seen)});
  }
  write_table(std::cout, table, TableFormat::kText);
  if (const std::size_t more = now.observations.size() - chosen.size(); more > 0)
    std::cout << "and " << more << " more cases: " << softwall_command("status", loaded.named) << "\n";
  std::cout << "\n"
            << describe_progress(loaded.campaign, now.observations, now.working, now.seconds_left) << "\n";
  if (now.owner) {
    std::cout << "Run by " << *now.owner << "." << std::endl;
  } else if (now.owner_is_unknown) {
    std::cout << "Whether anybody runs it cannot be asked: its campaign.lock belongs to another user."
              << std::endl;
  } else if (now.seconds_left > 0) {
    std::cout << "Nobody runs it now. To go on:  " << softwall_command("resume", loaded.named) << std::endl;
  }
}

/// How many cases a terminal has lines for, beside the lines around their table, two of which may be long.
std::size_t cases_on_terminal() {
  constexpr std::size_t kOtherLines = 8;
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0;
  if (!known) return std::numeric_limits<std::size_t>::max();
  return size.ws_row > kOtherLines ? size.ws_row - kOtherLines : 1;
}

}  // namespace

ExitStatus show_status(const std::filesystem::path& path, const StatusOptions& options) {
  const LoadedCampaign loaded = load_campaign(path);
  const Snapshot now = look(loaded);
  options.json ? print_json(loaded, now, options.why) : print_text(loaded, now, {.why = options.why});
  return ExitStatus::kDone;
}

ExitStatus watch_status(const std::filesystem::path& path, const StatusOptions& options) {
  const LoadedCampaign loaded = load_campaign(path);
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  bool seen_running = false;
  while (true) {
    const Snapshot now = look(loaded);
    if (terminal) std::cout << "\033[H\033[2J";
    TextLayout layout{.why = options.why};
    if (terminal) layout.most = cases_on_terminal();
    print_text(loaded, now, layout);
    const bool over = !now.owner && (seen_running || now.seconds_left <= 0);
    if (over || !std::cout) return ExitStatus::kDone;
    if (!now.owner && !now.owner_is_unknown)
      std::cout << "Waiting for a run to begin; Ctrl-C ends the waiting." << std::endl;
    seen_running = seen_running || now.owner.has_value();
    std::this_thread::sleep_for(std::chrono::seconds(2));
  }
}

}  // namespace softwall::campaign
