/// How the launcher hands cases to Slurm: which of them share a job, when the next one is submitted, and how
/// it comes to know whether that was accepted.
#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "campaign/launch/sbatch_answer.hpp"
#include "campaign/launch/slurm_command.hpp"
#include "campaign/launch/slurm_launcher.hpp"
#include "campaign/launch/slurm_pack.hpp"
#include "campaign/launch/slurm_size.hpp"
#include "campaign/launch/slurm_verdict.hpp"
#include "campaign/system/clock.hpp"
#include "solver/case/atomic_file.hpp"

namespace softwall::campaign {

/// What is to be submitted again stays together, because the same name finds a job that was accepted before.
/// The rest is put together anew; a job that is not full waits for more cases until the runner has started
/// all it can.
std::vector<SlurmLauncher::Group> SlurmLauncher::groups_to_submit(bool also_small_ones) {
  std::map<std::string, Group> again;
  std::vector<Group> groups;
  Group next;
  for (auto& [name, job] : jobs_) {
    if (job.stage != Stage::kWaiting) continue;
    if (!job.name.empty()) {
      again[job.name].push_back(&job);
      continue;
    }
    if (!next.empty() && !has_room(next, job.request.ranks)) groups.push_back(std::exchange(next, {}));
    next.push_back(&job);
    if (!has_room(next, 1)) groups.push_back(std::exchange(next, {}));
  }
  if (also_small_ones && !next.empty() && !may_grow(next)) groups.push_back(std::move(next));
  for (auto& [name, group] : again) groups.push_back(std::move(group));
  return groups;
}

bool SlurmLauncher::has_room(const Group& group, int ranks) const {
  for (const Job* job : group) ranks += job->request.ranks;
  return group.size() < static_cast<std::size_t>(options_.cases_per_job) &&
         ranks <= cores_of_a_node_.value_or(kUnlimitedCores);
}

/// Whether more cases may soon be there to share a job: those that are at work now, once they have ended.
bool SlurmLauncher::may_grow(const Group& group) const {
  const bool any_at_work =
      std::ranges::any_of(jobs_, [](const auto& one) { return one.second.stage != Stage::kWaiting; });
  const double oldest = std::ranges::min(group, {}, &Job::since)->since;
  return any_at_work && monotonic_seconds() - oldest < pace_.gathering;
}

/// One after the other while Slurm takes them; what is left over is submitted at the next occasion, so that a
/// person who wants softwall to stop is heard.
void SlurmLauncher::submit_waiting(bool also_small_ones) {
  const double began = monotonic_seconds();
  for (const Group& group : groups_to_submit(also_small_ones)) {
    queue_.refresh();
    if (!queue_.answers() || monotonic_seconds() < submit_at_) return;
    submit(group);
    if (monotonic_seconds() - began > pace_.submitting) return;
  }
}

std::vector<LaunchRequest> SlurmLauncher::requests_of(const Group& group) {
  std::vector<LaunchRequest> requests;
  for (const Job* job : group) requests.push_back(job->request);
  return requests;
}

/// Each case's script says in which job it runs before that job is submitted: whoever comes after us finds it
/// by that.
void SlurmLauncher::write_scripts(const Group& group) const {
  const auto requests = requests_of(group);
  const LaunchRequest all = together(requests);
  const auto& first = all.run_directory;
  if (group.size() > 1) write_atomically(pack_script(first), pack_text(requests));
  for (const Job* job : group) {
    LaunchRequest request = job->request;
    request.needed_seconds = all.needed_seconds;  // all have the time of the job
    write_atomically(job_script(request.run_directory),
                     script_text(request, options_, programs_, job_line(pack_name(requests))));
  }
}

/// Whether the job was accepted is known where sbatch says its number, or where it says why not. In all other
/// cases the queue is asked before it is submitted again.
void SlurmLauncher::submit(const Group& group) {
  write_scripts(group);
  const auto requests = requests_of(group);
  const LaunchRequest all = together(requests);
  const std::string name = pack_name(requests);
  auto arguments = submit_arguments(all, options_, name);
  if (group.size() > 1 && !options_.nodes) arguments.emplace_back("--nodes=1");
  arguments.push_back(group.size() > 1 ? pack_script(all.run_directory) : job_script(all.run_directory));
  const Answer answer = ask_slurm("sbatch", arguments, pace_.answer);
  queue_.hurry();
  const auto number = job_number_in(answer);
  const double now = monotonic_seconds();
  for (Job* job : group) {
    job->name = name;
    job->record.number = number.value_or("");
    job->stage = number ? Stage::kAccepted : is_doubtful(answer) ? Stage::kDoubtful : Stage::kWaiting;
    job->doubt_until = now + pace_.doubt;
  }
  if (number) {
    submit_pause_ = 0.0;
    tell("submit", "");
    return;
  }
  submit_pause_ = std::min(std::max(pace_.shortest, 2 * submit_pause_), pace_.longest_silence);
  submit_at_ = now + submit_pause_;
  tell("submit", "Slurm takes no job just now; trying again: " + trouble_in(answer, "sbatch"));
}

/// Called with an answer of Slurm's.
void SlurmLauncher::resolve_doubt(Job& job) {
  if (const auto& found = queue_.called(job.name); !found.empty()) {
    job.record.number = found.front().number;
    job.stage = Stage::kAccepted;
  } else if (queue_.asked_at() >= job.doubt_until) {
    job.stage = Stage::kWaiting;
  }
}

/// Two jobs of one name never work at once; the one that still waits has nothing to do.
void SlurmLauncher::cancel_extra(const std::vector<QueuedJob>& jobs) {
  const QueuedJob* const kept = most_alive(jobs);
  for (const QueuedJob& other : jobs) {
    if (other.number == kept->number || presence_in(other.state) != Presence::kQueued) continue;
    static_cast<void>(ask_slurm("scancel", {"--state=PENDING", other.number}, pace_.answer));
    queue_.hurry();
  }
}

/// A job may wait for ever for what this cluster does not have; only a person can tell.
void SlurmLauncher::tell_why_it_waits(const std::string& directory, const std::vector<QueuedJob>& jobs) {
  static constexpr std::array<std::string_view, 6> kUsual = {"",          "None",       "Priority",
                                                             "Resources", "Dependency", "BeginTime"};
  const QueuedJob* const found = most_alive(jobs);
  if (!found || presence_in(found->state) != Presence::kQueued) return;
  if (std::ranges::find(kUsual, found->why) != kUsual.end()) return;
  tell(found->name, directory + ": job " + found->number + " waits, says Slurm: " + found->why);
}

std::vector<std::string> SlurmLauncher::take_back() {
  std::vector<std::string> taken;
  std::erase_if(jobs_, [&](const auto& named) {
    const Job& job = named.second;
    if (job.stage != Stage::kWaiting) return false;
    clean_up(job.request.run_directory);  // without a script there is no job to look for
    taken.push_back(job.request.case_id);
    return true;
  });
  return taken;
}

}  // namespace softwall::campaign
