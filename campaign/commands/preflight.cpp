#include "campaign/commands/preflight.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <optional>
#include <string>

#include "campaign/core/case_mistakes.hpp"
#include "campaign/core/machine.hpp"
#include "campaign/observe/disk.hpp"
#include "campaign/system/find_program.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/file_descriptor.hpp"
#include "solver/run_directory/programs.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& where, const std::string& given, const std::string& allowed) {
  throw BadInput(where, {{"", given, allowed}});
}

/// softwall-dns: $SOFTWALL_DNS, or beside softwall itself. Throws BadInput.
fs::path find_solver() {
  if (const char* chosen = std::getenv("SOFTWALL_DNS"); chosen != nullptr && *chosen != '\0') {
    if (!is_program(chosen)) refuse("SOFTWALL_DNS", chosen, "an executable softwall-dns");
    return fs::absolute(chosen);
  }
  const fs::path beside = solver_program(folder_of_this_program(), Precision::kDouble);
  if (!is_program(beside)) {
    refuse("softwall-dns", "no executable " + beside.string(),
           "the solver built beside softwall, or named by the environment variable SOFTWALL_DNS");
  }
  return beside;
}

/// Memory of the cases that can be at work side by side: as many of the largest as the cores hold, precursors
/// first.
double memory_side_by_side(const Campaign& campaign, const std::vector<Decision>& decisions) {
  double most = 0;
  for (const bool precursors : {true, false}) {
    std::vector<std::pair<double, int>> cases;  // memory and ranks
    for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
      const CampaignCase& one = campaign.cases[i];
      if (one.is_precursor != precursors || !may_start(decisions[i].outlook)) continue;
      cases.emplace_back(memory_bytes(one.definition, one.ranks), one.ranks);
    }
    std::ranges::sort(cases, std::greater<>());
    int cores = campaign.execution.cores;
    double sum = 0;
    for (const auto& [bytes, ranks] : cases) {
      if (ranks > cores) continue;
      cores -= ranks;
      sum += bytes;
    }
    most = std::max(most, sum);
  }
  return most;
}

/// Physical memory, or what the control group of this process may have of it.
double memory_here() {
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  std::ifstream limit("/sys/fs/cgroup/memory.max");
  if (double allowed = 0; limit >> allowed && allowed > 0) bytes = std::min(bytes, allowed);
  return bytes;
}

/// The precisions whose solver does not stand beside `solver`, and where it was looked for.
std::map<std::string, std::string> missing_programs(const fs::path& solver) {
  const fs::path single = solver_program(fs::canonical(solver).parent_path(), Precision::kSingle);
  if (is_program(single)) return {};
  return {{name_of(Precision::kSingle), single.string()}};
}

/// The obstacles of every case that is yet to be started; in the list each is told once.
void add_obstacles_of_cases(const Campaign& campaign, const std::vector<Decision>& decisions,
                            const Machine& machine, Preflight& result) {
  CaseMistakes mistakes;
  std::size_t cases = 0;
  result.blocked.resize(campaign.cases.size());
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const CampaignCase& one = campaign.cases[i];
    if (!may_start(decisions[i].outlook)) continue;
    ++cases;
    auto found = obstacles(one, campaign.execution, machine);
    if (!found.empty())
      result.blocked[i] =
          "cannot be run here: " + found[0].where + ": " + found[0].given + "; " + found[0].allowed;
    mistakes.add(one.definition.label, "", std::move(found));
  }
  for (Mistake& mistake : mistakes.all(cases)) result.mistakes.push_back(std::move(mistake));
}

void add(const BadInput& error, std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : error.mistakes)
    mistakes.push_back({error.source, mistake.given, mistake.allowed});
}

/// Most ranks of a case that is yet to be started; 0: there is none, and nothing needs to be tried.
int most_ranks(const Campaign& campaign, const std::vector<Decision>& decisions) {
  int most = 0;
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (may_start(decisions[i].outlook)) most = std::max(most, campaign.cases[i].ranks);
  return most;
}

void prepare(Launcher& launcher, const fs::path& solver, int ranks, std::vector<Mistake>& mistakes) {
  try {
    launcher.prepare(solver, ranks);
  } catch (const BadInput& error) {
    add(error, mistakes);
  }
}

/// Open MPI aborts a solver whose checkpoint has a path of 247 characters (measured, 4.1.4).
void add_paths_that_are_too_long(const LoadedCampaign& loaded, const std::vector<Decision>& decisions,
                                 Preflight& result) {
  constexpr std::size_t kLongestPath = 240;
  std::string longest;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    if (!may_start(decisions[i].outlook)) continue;
    const RunFiles run{loaded.folder / loaded.campaign.cases[i].directory};
    const std::string path = run.checkpoint(0).string() + ".tmp";
    if (path.size() > longest.size()) longest = path;
  }
  if (longest.size() <= kLongestPath) return;
  result.mistakes.push_back(
      {longest, "a path of " + std::to_string(longest.size()) + " characters",
       "at most " + std::to_string(kLongestPath) + ": use a folder with a shorter name"});
}

/// What would become of the cases on a machine with any number of cores.
std::vector<Decision> decide_without_limit(Campaign campaign, const std::vector<Observation>& observations) {
  campaign.execution.cores = 0;
  return decide(campaign, observations);
}

}  // namespace

bool may_start(Outlook outlook) {
  return outlook == Outlook::kStart || outlook == Outlook::kResume || outlook == Outlook::kWaiting;
}

Preflight preflight(const LoadedCampaign& loaded, const std::vector<Observation>& observations,
                    Launcher& launcher) {
  const Campaign& campaign = loaded.campaign;
  const auto decisions = decide_without_limit(campaign, observations);
  Preflight result;
  const bool here = launcher.capacity().has_value();  // else a scheduler knows its machines, and we do not
  Machine machine{campaign.execution.cores, here ? memory_here() : 0.0, {}};
  const int ranks = most_ranks(campaign, decisions);
  std::vector<Mistake> unneeded;  // of programs, where nothing is to be started
  std::vector<Mistake>& of_programs = ranks > 0 ? result.mistakes : unneeded;
  std::optional<fs::path> solver;
  try {
    solver = find_solver();
    machine.missing_programs = missing_programs(*solver);
  } catch (const BadInput& error) {
    add(error, of_programs);
  }
  add_obstacles_of_cases(campaign, decisions, machine, result);
  add_paths_that_are_too_long(loaded, decisions, result);
  if (solver && result.mistakes.empty()) prepare(launcher, *solver, ranks, of_programs);
  if (!unneeded.empty()) result.no_programs = BadInput("", unneeded).what();
  result.disk = disk_need(campaign, observations);
  result.disk_free_bytes = static_cast<double>(fs::space(loaded.folder).available);
  result.memory_bytes = memory_side_by_side(campaign, decisions);
  result.machine_memory_bytes = machine.memory_bytes;
  result.machine_cores = machine.cores;
  if (result.disk.bytes() > result.disk_free_bytes) {
    result.mistakes.push_back({"disk", gigabytes(result.disk_free_bytes) + " free",
                               "this campaign has yet to write " + words_of(result.disk)});
  }
  if (here && result.memory_bytes > result.machine_memory_bytes && result.mistakes.empty()) {
    result.mistakes.push_back(
        {"/execution/cores",
         "cases side by side would take about " + gigabytes(result.memory_bytes) + " of memory",
         "this machine has " + gigabytes(result.machine_memory_bytes) + ": let fewer run at once"});
  }
  return result;
}

BadInput refusal(const Preflight& preflight, const fs::path& folder) {
  return {folder.string() + " cannot be run here", preflight.mistakes};
}

void require_nothing_in_the_way(const Preflight& preflight, const fs::path& folder) {
  if (!preflight.mistakes.empty()) throw refusal(preflight, folder);
}

void require_writable(const fs::path& folder) {
  std::string probe = folder / ".softwall-XXXXXX";  // a name that nobody, killed just here, has left behind
  const FileDescriptor file(mkostemp(probe.data(), O_CLOEXEC));
  if (!file)
    refuse(folder.string(), std::string("cannot be written: ") + std::strerror(errno), "a writable folder");
  unlink(probe.c_str());
}

}  // namespace softwall::campaign
