#include "campaign/launch/slurm_launcher.hpp"

#include <algorithm>
#include <csignal>
#include <set>
#include <system_error>
#include <utility>

#include "campaign/core/words.hpp"
#include "campaign/launch/sbatch_answer.hpp"
#include "campaign/launch/slurm_command.hpp"
#include "campaign/launch/slurm_pack.hpp"
#include "campaign/launch/slurm_size.hpp"
#include "campaign/launch/slurm_verdict.hpp"
#include "campaign/launch/solver_log.hpp"
#include "campaign/system/clock.hpp"
#include "campaign/system/file_system.hpp"
#include "campaign/system/find_program.hpp"
#include "campaign/system/work_marks.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/run_directory/report_file.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/run_directory/summary.hpp"

namespace softwall::campaign {
namespace {

/// A file that cannot be read just now is not missing.
bool is_missing(const std::filesystem::path& file) {
  std::error_code unreadable;
  return std::filesystem::status(file, unreadable).type() == std::filesystem::file_type::not_found;
}

/// Before it has a number.
JobRecord record_of(const LaunchRequest& request) {
  return {.name = job_name(request),
          .attempt = request.attempt,
          .number = "",
          .directory = canonical_run_directory(request.run_directory)};
}

}  // namespace

SlurmLauncher::SlurmLauncher(SlurmOptions options, SlurmPace pace)
    : options_(std::move(options)), pace_(pace), queue_(pace), rest_(pace.quiet) {}

void SlurmLauncher::prepare(const std::filesystem::path& solver, int ranks) {
  for (const char* program : {"sbatch", "squeue", "scancel"}) {
    if (!find_on_path(program))
      throw BadInput(program,
                     {{"", "not found on the PATH", "Slurm's commands, as on a login node of a cluster"}});
  }
  // The nodes may have another PATH than this machine, but where a program is here it is mostly there too.
  programs_ = {find_on_path(options_.start_with).value_or(options_.start_with), solver};
  const auto size = cluster_size(options_, pace_.answer);
  if (size) cores_of_a_node_ = size->cores_of_a_node;
  if (ranks == 0) return;
  const auto refuse = [&](const std::string& why) {
    throw BadInput("sbatch", {{"", "Slurm refuses a job of " + counted(ranks, "rank"), why}});
  };
  if (const std::string why = size ? why_too_large(ranks, options_, *size) : ""; !why.empty()) refuse(why);
  auto arguments = submit_arguments({"", "/", 0, ranks, std::nullopt}, options_, "softwall.trial");
  arguments.insert(arguments.end(), {"--test-only", "--wrap=true"});
  const Answer answer = ask_slurm("sbatch", arguments, pace_.answer);
  if (answer.exit_code != 0 && !may_pass(answer)) refuse(trouble_in(answer, "sbatch"));
}

Handle SlurmLauncher::intended(const LaunchRequest& request) const { return handle_of(record_of(request)); }

Handle SlurmLauncher::start(const LaunchRequest& request) {
  keep_small(RunFiles{request.run_directory}.log());
  remove_pack_files(request.run_directory);
  rest_.forget(request.run_directory);
  const JobRecord record = record_of(request);
  write_atomically(job_script(request.run_directory),
                   script_text(request, options_, programs_, job_line("")));
  const auto at = jobs_.insert_or_assign(
      record.name, Job{.request = request, .record = record, .name = "", .since = monotonic_seconds()});
  try {
    submit_waiting(false);
  } catch (...) {
    if (at.first->second.stage == Stage::kWaiting)
      jobs_.erase(at.first);  // the caller believes it never began
    throw;
  }
  return handle_of(at.first->second.record);
}

bool SlurmLauncher::adopt(const LaunchRequest& request, const Handle& handle) {
  const auto record = job_of(handle);
  if (!record) return false;
  const JobPlace place = place_of(*record, request.run_directory);
  const auto name = job_in(request.run_directory, record->name);
  const bool was_submitted = !name || !name->empty();
  if (place == JobPlace::kElsewhere || !was_submitted) return false;
  jobs_[record->name] = {.request = request,
                         .record = *record,
                         .name = name.value_or(""),
                         .stage = Stage::kAccepted,
                         .place = place,
                         .since = monotonic_seconds()};
  if (place == JobPlace::kUnclear)
    news_.push_back(request.run_directory.filename().string() + ": its folder was moved after the job " +
                    record->name + " had been submitted; waiting until Slurm no longer has it");
  return true;
}

std::vector<std::string> SlurmLauncher::news() { return std::exchange(news_, {}); }

/// Once, until something else is to be said about the same thing. Nothing: all is well again.
void SlurmLauncher::tell(const std::string& about, const std::string& what) {
  std::string& before = told_[about];
  if (before == what) return;
  if (what.empty())
    news_.emplace_back(about == "queue" ? "Slurm answers again" : "Slurm takes jobs again");
  else
    news_.push_back(what);
  before = what;
}

std::vector<EndedAttempt> SlurmLauncher::collect() {
  if (jobs_.empty()) return {};
  queue_.refresh();
  if (!queue_.answers()) {
    tell("queue", "Slurm does not answer; asking again: " + queue_.trouble());
    return {};
  }
  tell("queue", "");
  std::vector<Job> over;
  std::set<std::string> looked_at;  // jobs; several cases may share one
  for (auto& [name, job] : jobs_) {
    keep_small_while_written(RunFiles{job.request.run_directory}.log());
    if (job.stage == Stage::kDoubtful) resolve_doubt(job);
    if (job.stage != Stage::kAccepted) continue;
    if (job.name.empty())  // its script could not be read when it was adopted
      job.name = job_in(job.request.run_directory, job.record.name).value_or("");
    if (looked_at.insert(job.name).second) {
      const auto& jobs = queue_.called(job.name);
      if (job.place == JobPlace::kHere) cancel_extra(jobs);
      tell_why_it_waits(job.request.run_directory.filename(), jobs);
    }
    if (is_over(job)) over.push_back(job);
  }
  const auto ended = ends_of(over);
  for (const Job& job : over) {
    clean_up(job.request.run_directory);
    told_.erase(job.name);
    jobs_.erase(job.record.name);
  }
  submit_waiting(over.empty());  // what has just ended may go on, and is company for what waits
  return ended;
}

/// A job that is in the queue although its attempt has reached the end is one that Slurm has brought back, or
/// the second of a name. One of several cases passes over those that have ended.
bool SlurmLauncher::is_over(const Job& job) {
  const Presence presence = presence_of(job);
  if (presence != Presence::kQueued) return presence == Presence::kGone;
  if (job.name != job.record.name) return false;
  const auto summary =
      read_report<Summary>(RunFiles{job.request.run_directory}.summary(), job.request.case_id);
  const bool finished = summary && summary->attempt == job.record.attempt && summary->outcome == "finished";
  if (finished) stop(job.request.run_directory, handle_of(job.record), StopLevel::kCheckpoint);
  return false;
}

std::vector<EndedAttempt> SlurmLauncher::ends_of(const std::vector<Job>& over) const {
  std::vector<std::string> vanished;
  for (const Job& job : over) {
    if (queue_.called(job.name).empty()) vanished.push_back(job.name);
  }
  const auto past = queue_.past(vanished);
  std::vector<EndedAttempt> ended;
  for (const Job& job : over) {
    EndedAttempt end{job.request.case_id, std::nullopt, std::nullopt};
    auto jobs = queue_.called(job.name);
    if (const auto known = past.find(job.name); known != past.end()) jobs.push_back(known->second);
    if (const auto noted = packed_exit_code(job.request.run_directory, job.record.attempt)) {
      end.exit_code = noted;
    } else if (jobs.empty()) {
      end.verdict = {AttemptOutcome::kLost, "Slurm no longer knows its job, and the solver has left no word"};
    } else {
      end.exit_code = jobs.back().exit_code;
      end.verdict = verdict_on(jobs.back());
    }
    ended.push_back(std::move(end));
  }
  return ended;
}

/// What Slurm says about a job, completed by what its run directory says where Slurm does not vouch for its
/// end. A job of which it is not clear that it works here may not be taken for one that hangs.
Presence SlurmLauncher::presence_of(const Job& job) const {
  if (job.stage == Stage::kWaiting) return Presence::kQueued;
  if (job.stage == Stage::kDoubtful || job.name.empty()) return Presence::kUnknown;
  const auto& run_directory = job.request.run_directory;
  const bool is_packed = job.name != job.record.name;
  if (is_packed && packed_exit_code(run_directory, job.record.attempt))
    return lock_is_held(RunFiles{run_directory}.lock()) ? Presence::kRunning : Presence::kGone;
  const auto& jobs = queue_.called(job.name);
  const QueuedJob* const found = queue_.answers() ? most_alive(jobs) : nullptr;
  if (found && presence_in(found->state) != Presence::kGone)
    return job.place == JobPlace::kHere ? presence_in(found->state) : Presence::kUnknown;
  const RestWatch::Verdict rest = rest_.look(run_directory, job.record.attempt);
  if (rest == RestWatch::Verdict::kAtWork) return Presence::kRunning;
  const bool vouched_for = found && leaves_no_process(found->state);
  if (!vouched_for && !ProcessesAtWork::look().in(run_directory).empty()) return Presence::kRunning;
  const bool is_over = vouched_for || rest == RestWatch::Verdict::kAtRest;
  return is_over && queue_.answers() ? Presence::kGone : Presence::kUnknown;
}

/// Of an attempt that was neither started nor adopted here.
Presence SlurmLauncher::presence_of_another(const std::filesystem::path& run_directory,
                                            const JobRecord& record) const {
  const JobPlace place = place_of(record, run_directory);
  if (place == JobPlace::kElsewhere) return Presence::kGone;
  const auto name = job_in(run_directory, record.name);
  if (!name) return is_missing(job_script(run_directory)) ? Presence::kGone : Presence::kUnknown;
  if (name->empty()) return Presence::kGone;  // never submitted
  const LaunchRequest request{.case_id = "", .run_directory = run_directory, .attempt = record.attempt};
  return presence_of(
      {.request = request, .record = record, .name = *name, .stage = Stage::kAccepted, .place = place});
}

std::vector<Presence> SlurmLauncher::presences(const std::vector<AttemptPlace>& places) const {
  std::vector<Presence> found;
  for (const AttemptPlace& place : places) {
    const auto job = job_of(place.handle);
    if (!job) {
      found.push_back(Presence::kGone);
      continue;
    }
    queue_.refresh();  // asks once; the answer holds for all of them
    const auto own = jobs_.find(job->name);
    found.push_back(own != jobs_.end() ? presence_of(own->second)
                                       : presence_of_another(place.run_directory, *job));
  }
  return found;
}

/// A request that does not reach Slurm is repeated by whoever makes it. Processes that Slurm has lost,
/// because their node's daemon died, are ended by us where they are on this machine.
void SlurmLauncher::stop(const std::filesystem::path& run_directory, const Handle& handle, StopLevel level) {
  const auto job = job_of(handle);
  if (!job || place_of(*job, run_directory) != JobPlace::kHere) return;
  const std::string name = job_in(run_directory, job->name).value_or(job->name);
  if (name != job->name) {
    ask_packed(run_directory, level);
  } else {
    for (const auto& arguments : cancel_arguments(name, level, options_))
      static_cast<void>(ask_slurm("scancel", arguments, pace_.answer));
    queue_.hurry();
  }
  const QueuedJob* const found = most_alive(queue_.called(name));
  if (level == StopLevel::kCheckpoint || (found && presence_in(found->state) != Presence::kGone)) return;
  for (const pid_t pid : ProcessesAtWork::look().in(run_directory))
    kill(pid, level == StopLevel::kKill ? SIGKILL : SIGTERM);
}

void SlurmLauncher::clean_up(const std::filesystem::path& run_directory) {
  std::error_code ignored;
  std::filesystem::remove(job_script(run_directory), ignored);
  remove_pack_files(run_directory);
  rest_.forget(run_directory);
}

}  // namespace softwall::campaign
