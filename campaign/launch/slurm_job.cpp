#include "campaign/launch/slurm_job.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <xxhash.h>
#include <nlohmann/json.hpp>

#include "campaign/system/shell_words.hpp"
#include "campaign/system/work_marks.hpp"
#include "solver/case/hexadecimal.hpp"
#include "solver/case/json_text.hpp"
#include "solver/run_directory/exit_codes.hpp"
#include "solver/run_directory/run_files.hpp"

/// Why a job is asked for as it is (all measured with Slurm 22.05 and Open MPI 4.1):
///
/// --no-requeue: Slurm does not run a job again by itself, after its node failed or another took its place.
///   Every launch is an attempt in the store, and before each launch checkpoints are read in full. After a
///   node has failed, its processes may still be writing; softwall waits for their silence, Slurm would not.
///   The price: while nobody runs softwall, a job that was taken away is not begun again. A job that an
///   administrator has requeued all the same ends at once, and softwall submits another.
/// --dependency=singleton: of two jobs of one name only one is at work. Should one attempt ever be submitted
///   twice, the second finds nothing left to do.
/// --signal=B:USR1 and exec mpirun: the signal reaches only the job's first process, and that is mpirun then,
///   which passes it on to every rank. srun's ranks are steps of the job and get it without B.
/// --open-mode=append, and the log by a name relative to --chdir: attempts add to one log, and no character
/// of
///   the folder's name is taken for a pattern of Slurm's.
namespace softwall::campaign {
namespace {

using nlohmann::json;

constexpr double kLongestStart = 60.0;  // s, of the ranks of a job

std::string plain(std::string text, std::size_t longest) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("._=+-").find(static_cast<char>(c)) != std::string_view::npos;
  };
  std::ranges::replace_if(
      text, [&](char c) { return !is_plain(static_cast<unsigned char>(c)); }, '-');
  return text.substr(0, longest);
}

bool starts_with_srun(const SlurmOptions& slurm) { return slurm.start_with == "srun"; }

std::string signal_option(const SlurmOptions& slurm) {
  return std::string("--signal=") + (starts_with_srun(slurm) ? "" : "B:") + "USR1@" +
         std::to_string(slurm.signal_seconds);
}

std::vector<std::string> solver_command(const LaunchRequest& request, const SlurmOptions& slurm,
                                        const JobPrograms& programs) {
  std::vector<std::string> words = {programs.starter};
  words.insert(words.end(), slurm.start_options.begin(), slurm.start_options.end());
  words.insert(words.end(), {"-n", std::to_string(request.ranks), programs.solver, request.run_directory,
                             "--attempt", std::to_string(request.attempt)});
  if (const auto seconds = solver_seconds(request, slurm))
    words.insert(words.end(), {"--wall-seconds", normalised_number(*seconds).dump()});
  return words;
}

}  // namespace

Handle handle_of(const JobRecord& job) {
  const json object = {
      {"slurm", job.name}, {"attempt", job.attempt}, {"job", job.number}, {"directory", job.directory}};
  // A directory may have any name; one that is no UTF-8 is not found again.
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<JobRecord> job_of(const Handle& handle) {
  const json object = json::parse(handle, nullptr, false);
  if (!object.is_object() || !object.contains("slurm")) return std::nullopt;
  try {
    return JobRecord{object.at("slurm"), object.at("attempt"), object.at("job"),
                     object.value("directory", std::string())};
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::string job_name_beginning(const std::filesystem::path& run_directory) {
  constexpr std::size_t kLongestFolder = 40;
  const auto directory = canonical_run_directory(run_directory);
  return "softwall." + plain(directory.parent_path().parent_path().filename(), kLongestFolder) + ".";
}

std::string job_name(const LaunchRequest& request) {
  constexpr std::size_t kLongestCase = 100;
  const std::filesystem::path directory = canonical_run_directory(request.run_directory);
  const std::string path = directory;
  return job_name_beginning(directory) + plain(directory.filename(), kLongestCase) + "." +
         std::to_string(request.attempt) + "." + hexadecimal(XXH3_64bits(path.data(), path.size()));
}

std::filesystem::path job_script(const std::filesystem::path& run_directory) {
  return run_directory / "job.sh";
}

std::string leave_when_begun_again() {
  return "if [ \"${SLURM_RESTART_COUNT:-0}\" -gt 0 ]; then\n"
         "  echo 'softwall: Slurm has begun this job again; it ends, and softwall submits another'\n"
         "  exit " +
         std::to_string(static_cast<int>(ExitCode::kInterrupted)) + "\nfi\n";
}

std::string script_text(const LaunchRequest& request, const SlurmOptions& slurm, const JobPrograms& programs,
                        const std::string& job_line) {
  std::string text = "#!/bin/sh\n# Attempt " + std::to_string(request.attempt) +
                     ", as softwall has submitted it. Slurm has a copy of its own.\n" + job_line;
  text += leave_when_begun_again();
  text += "export OMP_NUM_THREADS=1\n";
  text += "export " + std::string(kRunDirectoryVariable) + "=" +
          script_word(canonical_run_directory(request.run_directory)) + "\n";
  text += "read -r _ _ _ _ _ " + std::string(kSessionVariable) + " _ < /proc/$$/stat; export " +
          kSessionVariable + "\n";
  if (geteuid() == 0) text += "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1\n";
  text += "exec";
  for (const std::string& word : solver_command(request, slurm, programs)) text += " " + script_word(word);
  return text + "\n";
}

std::vector<std::string> submit_arguments(const LaunchRequest& request, const SlurmOptions& slurm,
                                          const std::string& name) {
  std::vector<std::string> words = {"--parsable",
                                    "--job-name=" + name,
                                    "--chdir=" + request.run_directory.string(),
                                    "--output=" + RunFiles{request.run_directory}.log().filename().string(),
                                    "--open-mode=append",
                                    "--no-requeue",
                                    "--dependency=singleton",
                                    "--ntasks=" + std::to_string(request.ranks),
                                    signal_option(slurm)};
  if (!slurm.account.empty()) words.push_back("--account=" + slurm.account);
  if (!slurm.partition.empty()) words.push_back("--partition=" + slurm.partition);
  if (const auto minutes = time_limit(request, slurm)) words.push_back("--time=" + std::to_string(*minutes));
  if (slurm.nodes) words.push_back("--nodes=" + std::to_string(*slurm.nodes));
  words.insert(words.end(), slurm.options.begin(), slurm.options.end());
  return words;
}

std::vector<std::vector<std::string>> cancel_arguments(const std::string& name, StopLevel level,
                                                       const SlurmOptions& slurm) {
  const std::vector<std::string> all = {"--user=" + std::to_string(geteuid()), "--name=" + name};
  const auto with = [&](std::vector<std::string> words) {
    words.insert(words.begin(), all.begin(), all.end());
    return words;
  };
  switch (level) {
    case StopLevel::kCheckpoint: {
      // A job in the queue has nothing to write, and takes no signal.
      std::vector<std::string> signal = {"--signal=USR1"};
      if (!starts_with_srun(slurm)) signal.emplace_back("--batch");
      return {with({"--state=PENDING"}), with(signal)};
    }
    case StopLevel::kTerminate:
      return {with({})};  // TERM for every process, and some time later KILL
    case StopLevel::kKill:
      break;
  }
  return {with({"--full", "--signal=KILL"}), with({})};
}

/// A short job finds its place earlier. One that turns out too short costs a restart and no step.
std::optional<int> time_limit(const LaunchRequest& request, const SlurmOptions& slurm) {
  constexpr double kMargin = 1.25;  // steps become shorter and nodes slower
  constexpr double kLeast = 600.0;  // s; below that nothing is gained
  if (!slurm.time_limit_minutes || !request.needed_seconds) return slurm.time_limit_minutes;
  const double needed = kMargin * *request.needed_seconds + kLongestStart + slurm.signal_seconds;
  const double most = *slurm.time_limit_minutes;
  return static_cast<int>(std::min(most, std::ceil(std::max(needed, kLeast) / 60.0)));
}

std::optional<double> solver_seconds(const LaunchRequest& request, const SlurmOptions& slurm) {
  const auto minutes = time_limit(request, slurm);
  if (!minutes) return request.wall_seconds;
  // The job's time begins before the solver's: its ranks have to be started first.
  constexpr double kShareOfStart = 0.1;
  const double limit = 60.0 * *minutes;
  const double ours = limit - std::min(kLongestStart, kShareOfStart * limit);
  return std::min(ours, request.wall_seconds.value_or(ours));
}

}  // namespace softwall::campaign
