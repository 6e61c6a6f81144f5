#include "campaign/launch/process_launcher.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#include <nlohmann/json.hpp>

#include "campaign/launch/scratch.hpp"
#include "campaign/system/clock.hpp"
#include "campaign/system/find_program.hpp"
#include "campaign/system/process_identity.hpp"
#include "campaign/system/signals.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/file_descriptor.hpp"
#include "solver/case/json_text.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {
namespace {

// Ranks notice the death of their mpirun after about one second (measured, Open MPI 4.1.4).
constexpr double kRankGraceSeconds = 5.0;

[[noreturn]] void throw_errno(const std::string& what, int error) {
  throw std::runtime_error(what + ": " + std::strerror(error));
}

/// Our environment with what an attempt needs; the names set here replace those inherited.
std::vector<std::string> launch_environment(const LaunchRequest& request, const Scratch& scratch) {
  std::vector<std::string> settings = {
      std::string(kRunDirectoryVariable) + "=" + request.run_directory.string(),
      "TMPDIR=" + scratch.session().string(),
      "OMPI_MCA_btl_vader_backing_directory=" + scratch.shared_memory().string(),
      "OMP_NUM_THREADS=1",
  };
  // A rank that waits lets others have its core: on a machine that does anything else besides, 2 ranks of a
  // small case took 1.7 s instead of 27 s (measured at a load of 15 on 2 cores).
  if (std::getenv("OMPI_MCA_mpi_yield_when_idle") == nullptr) {
    settings.emplace_back("OMPI_MCA_mpi_yield_when_idle=1");
  }
  if (geteuid() == 0) {
    settings.emplace_back("OMPI_ALLOW_RUN_AS_ROOT=1");
    settings.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1");
  }
  const std::size_t own = settings.size();
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string_view name = text.substr(0, text.find('=') + 1);
    bool replaced = false;
    for (std::size_t i = 0; i < own; ++i) replaced = replaced || settings[i].starts_with(name);
    if (!replaced) settings.emplace_back(text);
  }
  return settings;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

struct ChildSetup {
  pid_t parent;
  int input, output, report;  ///< descriptors: standard input, log, and where an exec error is told
  char* const* arguments;
  char* const* environment;
};

/// The child between fork and exec: only system calls.
[[noreturn]] void become_launcher(const ChildSetup& setup) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGUSR1);
  if (getppid() != setup.parent) _exit(1);  // the runner died before the line above
  restore_default_signals();
  dup2(setup.input, STDIN_FILENO);
  dup2(setup.output, STDOUT_FILENO);
  dup2(setup.output, STDERR_FILENO);
  execve(setup.arguments[0], setup.arguments, setup.environment);
  const int error = errno;
  if (write(setup.report, &error, sizeof error) < 0) _exit(126);
  _exit(127);
}

int exit_code_of(int wait_status) {
  return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

/// Asks whatever works in run_directory, whoever started it, to end.
void signal_attempt(const std::filesystem::path& run_directory, StopLevel level) {
  const auto processes = processes_of(run_directory);
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
  std::vector<std::string> arguments = {programs.mpirun, "--bind-to", "none", "--use-hwthread-cpus"};
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

void ProcessLauncher::prepare(const std::filesystem::path& solver) {
  const auto mpirun = find_on_path("mpirun");
  if (!mpirun) {
    throw BadInput("mpirun",
                   {{"", "not found on the PATH", "Open MPI (on Debian: apt install openmpi-bin)"}});
  }
  programs_ = {*mpirun, solver};
}

Handle ProcessLauncher::start(const LaunchRequest& request) {
  const Scratch scratch(request.run_directory);
  scratch.create();
  auto arguments = launch_arguments(programs_, request);
  auto environment = launch_environment(request, scratch);
  const auto argument_pointers = pointers_to(arguments);
  const auto environment_pointers = pointers_to(environment);

  const FileDescriptor input(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const auto log = RunFiles{request.run_directory}.log();
  const FileDescriptor output(open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (!output) throw_errno("cannot write " + log.string(), errno);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_errno("cannot make a pipe", errno);
  const FileDescriptor report_in(ends[0]);
  FileDescriptor report_out(ends[1]);

  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw_errno("cannot start another process", errno);
  if (child == 0) {
    become_launcher({parent, input.get(), output.get(), report_out.get(), argument_pointers.data(),
                     environment_pointers.data()});
  }
  setpgid(child, child);  // both sides set it, so that it holds whoever runs first
  if (!report_out.close()) throw_errno("cannot close a pipe", errno);
  int error = 0;
  if (read(report_in.get(), &error, sizeof error) > 0) {
    waitpid(child, nullptr, 0);
    scratch.remove();
    throw_errno("cannot start " + arguments[0], error);
  }
  running_[request.case_id] = {request.run_directory, child};
  return nlohmann::json(identify(child)).dump();
}

bool ProcessLauncher::is_over(Running& attempt) const {
  if (!attempt.ended) {
    int status = 0;
    if (waitpid(attempt.leader, &status, WNOHANG) != attempt.leader) return false;
    attempt.ended = true;
    attempt.exit_code = exit_code_of(status);
    attempt.ended_at = monotonic_seconds();
  }
  // "mpirun is gone" does not mean that no rank is writing: wait for the last one, help after a while.
  if (processes_of(attempt.run_directory).empty()) return true;
  if (monotonic_seconds() - attempt.ended_at > kRankGraceSeconds) {
    signal_attempt(attempt.run_directory, StopLevel::kKill);
  }
  return false;
}

std::vector<EndedAttempt> ProcessLauncher::collect() {
  std::vector<EndedAttempt> ended;
  for (auto item = running_.begin(); item != running_.end();) {
    if (!is_over(item->second)) {
      ++item;
      continue;
    }
    Scratch(item->second.run_directory).remove();
    ended.push_back({item->first, item->second.exit_code});
    item = running_.erase(item);
  }
  return ended;
}

Presence ProcessLauncher::presence(const std::filesystem::path& run_directory, const Handle&) const {
  return processes_of(run_directory).empty() ? Presence::kGone : Presence::kRunning;
}

void ProcessLauncher::stop(const std::filesystem::path& run_directory, const Handle&, StopLevel level) {
  signal_attempt(run_directory, level);
}

void ProcessLauncher::clean_up(const std::filesystem::path& run_directory) {
  Scratch(run_directory).remove();
}

std::optional<int> ProcessLauncher::capacity() const {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ProcessLauncher::~ProcessLauncher() {
  for (auto& [id, attempt] : running_) {
    signal_attempt(attempt.run_directory, StopLevel::kKill);
    if (!attempt.ended) waitpid(attempt.leader, nullptr, 0);
  }
}

}  // namespace softwall::campaign
