#include "campaign/launch/slurm_pack.hpp"

#include <algorithm>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>

#include <xxhash.h>

#include "campaign/launch/slurm_job.hpp"
#include "campaign/system/shell_words.hpp"
#include "campaign/system/work_marks.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/case/hexadecimal.hpp"

namespace softwall::campaign {
namespace {

constexpr std::string_view kJobLine = "# job: ";
constexpr const char* kNoJob = "none yet";

std::filesystem::path end_file(const std::filesystem::path& run_directory) {
  return run_directory / "job.end";
}
std::filesystem::path request_file(const std::filesystem::path& run_directory) {
  return run_directory / "job.stop";
}

const char* signal_of(StopLevel level) {
  switch (level) {
    case StopLevel::kCheckpoint:
      return "USR1";
    case StopLevel::kTerminate:
      return "TERM";
    case StopLevel::kKill:
      break;
  }
  return "KILL";
}

/// One case of the job, in a shell of its own. A case that has been taken back, or runs in another job by
/// now, is passed over. Slurm's TERM reaches every process by itself (and makes mpirun leave with 1, as any
/// failure does); USR1 reaches the job's first shell only. The nap is waited for, because a shell sees to
/// signals only between two commands and while it waits.
constexpr const char* kRunOne = R"(run() {
  cd "$1" && grep -qxF "# job: $job" job.sh || return 0
  solver=
  trap '[ -z "$solver" ] || kill -USR1 $solver' USR1
  trap 'ended=143' TERM
  sh job.sh >>solver.log 2>&1 & solver=$!
  while kill -0 $solver 2>/dev/null; do
    if read -r signal <job.stop; then rm -f job.stop; kill -"$signal" $solver; fi 2>/dev/null
    sleep 2 & wait $!
  done
  wait $solver
  status=$?
  if [ $status -eq 1 ]; then status=${ended:-1}; fi
  echo "$2 $status" >job.end.new && mv job.end.new job.end
}
)";

/// Before any of them is started: a signal ends nothing by itself.
constexpr const char* kHearSignals = R"(cases=
trap '[ -z "$cases" ] || kill -USR1 $cases' USR1
trap : TERM
)";

/// Until the last of them has ended, however often a signal ends the waiting.
constexpr const char* kWaitForAll = R"(for one in $cases; do
  while kill -0 $one 2>/dev/null; do wait $one; done
done
)";

}  // namespace

std::string pack_name(const std::vector<LaunchRequest>& cases) {
  if (cases.size() == 1) return job_name(cases.front());
  std::string attempts;
  for (const LaunchRequest& one : cases) attempts += job_name(one) + "\n";
  return job_name_beginning(cases.front().run_directory) + std::to_string(cases.size()) + "-cases." +
         hexadecimal(XXH3_64bits(attempts.data(), attempts.size()));
}

LaunchRequest together(const std::vector<LaunchRequest>& cases) {
  LaunchRequest all = cases.front();
  for (const LaunchRequest& one : std::span(cases).subspan(1)) {
    all.ranks += one.ranks;
    const bool known = all.needed_seconds && one.needed_seconds;
    all.needed_seconds = known ? std::max(all.needed_seconds, one.needed_seconds) : std::nullopt;
  }
  return all;
}

std::filesystem::path pack_script(const std::filesystem::path& run_directory) {
  return run_directory / "jobs.sh";
}

std::string pack_text(const std::vector<LaunchRequest>& cases) {
  std::string text = "#!/bin/sh\n# " + std::to_string(cases.size()) +
                     " cases in one job, as softwall has submitted them. Slurm has a copy of its own.\n";
  // Several mpirun on one node would each bind their ranks to its first cores (Open MPI 4, and 5).
  text += "export OMPI_MCA_hwloc_base_binding_policy=none PRTE_MCA_hwloc_default_binding_policy=none\n";
  // Where cases are started by srun, each would take all processors of the job, and the others wait for it.
  text += "export SLURM_EXACT=1\n";
  text += leave_when_begun_again() + "job=" + script_word(pack_name(cases)) + "\n" + kRunOne + kHearSignals;
  for (const LaunchRequest& one : cases) {
    text += "run " + script_word(canonical_run_directory(one.run_directory)) + " " +
            std::to_string(one.attempt) + " & cases=\"$cases $!\"\n";
  }
  return text + kWaitForAll;
}

std::string job_line(const std::string& name) {
  return std::string(kJobLine) + (name.empty() ? kNoJob : name) + "\n";
}

std::optional<std::string> job_in(const std::filesystem::path& run_directory, const std::string& otherwise) {
  std::ifstream in(job_script(run_directory));
  if (!in) return std::nullopt;
  for (std::string line; std::getline(in, line) && line.starts_with("#");) {
    if (!line.starts_with(kJobLine)) continue;
    const std::string name = line.substr(kJobLine.size());
    return name == kNoJob ? "" : name;
  }
  return otherwise;
}

std::optional<int> packed_exit_code(const std::filesystem::path& run_directory, int attempt) {
  std::ifstream in(end_file(run_directory));
  int of_attempt = 0, exit_code = 0;
  if (!(in >> of_attempt >> exit_code) || of_attempt != attempt) return std::nullopt;
  return exit_code;
}

void ask_packed(const std::filesystem::path& run_directory, StopLevel level) {
  try {
    write_atomically(request_file(run_directory), std::string(signal_of(level)) + "\n");
  } catch (const std::system_error&) {  // whoever asks repeats it
  }
}

void remove_pack_files(const std::filesystem::path& run_directory) {
  std::error_code ignored;
  for (const auto& file : {pack_script(run_directory), end_file(run_directory), request_file(run_directory)})
    std::filesystem::remove(file, ignored);
}

}  // namespace softwall::campaign
