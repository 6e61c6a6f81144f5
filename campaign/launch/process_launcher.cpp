#include "campaign/launch/process_launcher.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <set>
#include <thread>

#include <nlohmann/json.hpp>

#include "campaign/core/words.hpp"
#include "campaign/launch/launch_environment.hpp"
#include "campaign/launch/scratch.hpp"
#include "campaign/launch/solver_log.hpp"
#include "campaign/launch/start_program.hpp"
#include "campaign/launch/trial.hpp"
#include "campaign/system/clock.hpp"
#include "campaign/system/find_program.hpp"
#include "campaign/system/process_identity.hpp"
#include "campaign/system/work_marks.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/json_text.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {
namespace {

// Ranks notice the death of their mpirun after about one second (measured, Open MPI 4.1.4).
constexpr double kRankGraceSeconds = 5.0;

/// Asks processes of one attempt to end.
void signal_attempt(const std::vector<pid_t>& processes, StopLevel level) {
  for (const pid_t process : processes) {
    if (level == StopLevel::kKill) {
      kill(process, SIGKILL);
      continue;
    }
    // Only mpirun, or what has outlived it, is asked: it forwards SIGUSR1 to all ranks, and turns SIGTERM
    // into TERM and, two seconds later, KILL of all ranks.
    const bool has_parent_here = std::ranges::find(processes, parent_of(process)) != processes.end();
    if (!has_parent_here) kill(process, level == StopLevel::kCheckpoint ? SIGUSR1 : SIGTERM);
  }
}

}  // namespace

std::vector<std::string> launch_arguments(const ProcessLauncher::Programs& programs,
                                          const LaunchRequest& request) {
  // Without --bind-to none every mpirun would bind its first rank to the same core.
  // Slots are what this machine has, whatever a hostfile of the installation or of the user says.
  std::vector<std::string> arguments = {programs.mpirun,       "--bind-to",          "none",
                                        "--use-hwthread-cpus", "--default-hostfile", "none"};
  if (request.ranks > static_cast<int>(std::thread::hardware_concurrency())) {
    arguments.emplace_back("--oversubscribe");
  }
  arguments.insert(arguments.end(), {"-n", std::to_string(request.ranks), programs.solver,
                                     request.run_directory, "--attempt", std::to_string(request.attempt)});
  if (request.wall_seconds) {
    arguments.insert(arguments.end(), {"--wall-seconds", normalised_number(*request.wall_seconds).dump()});
  }
  return arguments;
}

void ProcessLauncher::prepare(const std::filesystem::path& solver, int ranks) {
  const auto mpirun = find_on_path("mpirun");
  if (!mpirun) {
    throw BadInput("mpirun",
                   {{"", "not found on the PATH", "Open MPI (on Debian: apt install openmpi-bin)"}});
  }
  programs_ = {*mpirun, solver};
  if (ranks == 0) return;
  ProcessLauncher idle({*mpirun, find_on_path("echo").value_or("/bin/echo")});
  const std::string trouble = trouble_with_launch(idle, ranks);
  if (trouble.empty()) return;
  throw BadInput("mpirun", {{"", mpirun->string() + " cannot start " + counted(ranks, "rank"), trouble}});
}

Handle ProcessLauncher::start(const LaunchRequest& request) {
  keep_small(RunFiles{request.run_directory}.log());
  const Scratch scratch(request.run_directory);
  scratch.create();
  try {
    const pid_t mpirun = start_program({launch_arguments(programs_, request),
                                        launch_environment(own_environment(), request.run_directory, scratch),
                                        request.run_directory, RunFiles{request.run_directory}.log()});
    running_[request.case_id] = {request.run_directory, mpirun};
    return nlohmann::json(identify(mpirun)).dump();
  } catch (...) {
    if (!running_.contains(request.case_id)) scratch.remove();
    throw;
  }
}

void ProcessLauncher::note_end(Running& attempt) const {
  int status = 0;
  if (attempt.ended || waitpid(attempt.leader, &status, WNOHANG) != attempt.leader) return;
  attempt.ended = true;
  attempt.exit_code = exit_code_of(status);
  attempt.ended_at = monotonic_seconds();
}

/// "mpirun is gone" does not mean that no rank is writing: waits for the last one, and helps after a while.
std::vector<EndedAttempt> ProcessLauncher::collect() {
  std::set<pid_t> sessions;  // of those whose mpirun has ended, which it led
  for (auto& [id, attempt] : running_) {
    note_end(attempt);
    keep_small_while_written(RunFiles{attempt.run_directory}.log());
    if (attempt.ended) sessions.insert(attempt.leader);
  }
  if (sessions.empty()) return {};
  const ProcessesAtWork work = ProcessesAtWork::look_in(sessions);
  std::vector<EndedAttempt> ended;
  for (auto item = running_.begin(); item != running_.end();) {
    const Running& attempt = item->second;
    const auto ranks = attempt.ended ? work.in(attempt.run_directory) : std::vector<pid_t>();
    if (!attempt.ended || !ranks.empty()) {
      const bool late = attempt.ended && monotonic_seconds() - attempt.ended_at > kRankGraceSeconds;
      if (late) signal_attempt(ranks, StopLevel::kKill);
      ++item;
      continue;
    }
    Scratch(attempt.run_directory).remove();
    ended.push_back({item->first, attempt.exit_code});
    item = running_.erase(item);
  }
  return ended;
}

std::vector<Presence> ProcessLauncher::presences(const std::vector<AttemptPlace>& places) const {
  const ProcessesAtWork work = ProcessesAtWork::look();
  std::vector<Presence> found;
  for (const AttemptPlace& place : places) {
    found.push_back(work.in(place.run_directory).empty() ? Presence::kGone : Presence::kRunning);
  }
  return found;
}

void ProcessLauncher::stop(const std::filesystem::path& run_directory, const Handle&, StopLevel level) {
  signal_attempt(ProcessesAtWork::look().in(run_directory), level);
}

void ProcessLauncher::clean_up(const std::filesystem::path& run_directory) {
  Scratch(run_directory).remove();
}

std::optional<int> ProcessLauncher::capacity() const {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ProcessLauncher::~ProcessLauncher() {
  const ProcessesAtWork work = ProcessesAtWork::look();
  for (auto& [id, attempt] : running_) {
    signal_attempt(work.in(attempt.run_directory), StopLevel::kKill);
    if (!attempt.ended) kill(attempt.leader, SIGKILL);  // also one that has not yet become mpirun
    if (!attempt.ended) waitpid(attempt.leader, nullptr, 0);
  }
}

}  // namespace softwall::campaign
