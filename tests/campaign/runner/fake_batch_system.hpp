#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "campaign/launch/launcher.hpp"

/// A batch system and its launcher, as an exercise of the border: jobs wait in a queue and go on without the
/// softwall that submitted them.
namespace softwall::test {

/// What goes on outside softwall, whichever softwall asks.
struct BatchSystem {
  struct Job {
    campaign::LaunchRequest request;
    campaign::Presence state = campaign::Presence::kQueued;
  };
  std::map<campaign::Handle, Job> jobs;                      ///< by number
  bool is_full = false;                                      ///< true: whoever waits goes on waiting
  std::size_t most_jobs = 1000;                              ///< more than these it does not take
  bool answers = true;                                       ///< false: its commands fail for the time being
  std::function<void(const campaign::LaunchRequest&)> play;  ///< what the solver of a job leaves

  campaign::Handle submit(const campaign::LaunchRequest& request) {
    const campaign::Handle number = "job " + std::to_string(jobs.size() + 1);
    jobs[number] = {request};
    return number;
  }
  /// Every job moves on: from the queue to a node, from there to its end.
  void pass_time() {
    if (is_full) return;
    for (auto& [number, job] : jobs) {
      if (job.state == campaign::Presence::kRunning) {
        play(job.request);
        job.state = campaign::Presence::kGone;
      }
      if (job.state == campaign::Presence::kQueued) job.state = campaign::Presence::kRunning;
    }
  }
};

class BatchLauncher final : public campaign::Launcher {
 public:
  explicit BatchLauncher(BatchSystem& system) : system_(system) {}

  void prepare(const std::filesystem::path&, int) override {}
  campaign::Handle start(const campaign::LaunchRequest& request) override {
    started.push_back(request.case_id);
    if (on_start) on_start();
    if (system_.jobs.size() >= system_.most_jobs) {
      not_submitted_.push_back(request.case_id);
      return "to be submitted";
    }
    const campaign::Handle number = system_.submit(request);
    watched_.insert(number);
    return number;
  }
  std::vector<std::string> take_back() override { return std::exchange(not_submitted_, {}); }
  bool adopt(const campaign::LaunchRequest& request, const campaign::Handle& handle) override {
    adopted.push_back(request.case_id);
    watched_.insert(handle);
    return true;
  }
  [[nodiscard]] bool attempts_stay() const override { return true; }
  std::vector<campaign::EndedAttempt> collect() override {
    if (on_pass) on_pass();
    system_.pass_time();
    std::vector<campaign::EndedAttempt> ended;
    std::erase_if(watched_, [&](const campaign::Handle& number) {
      const auto& job = system_.jobs.at(number);
      if (job.state != campaign::Presence::kGone) return false;
      ended.push_back({job.request.case_id, std::nullopt});
      return true;
    });
    return ended;
  }
  [[nodiscard]] bool idle() const override { return watched_.empty() && not_submitted_.empty(); }
  [[nodiscard]] std::vector<campaign::Presence> presences(
      const std::vector<campaign::AttemptPlace>& places) const override {
    std::vector<campaign::Presence> found;
    for (const campaign::AttemptPlace& place : places) found.push_back(presence_of(place.handle));
    return found;
  }
  void stop(const std::filesystem::path&, const campaign::Handle& handle,
            campaign::StopLevel level) override {
    stops.emplace_back(handle, level);
  }
  void clean_up(const std::filesystem::path&) override {}
  [[nodiscard]] std::optional<int> capacity() const override { return std::nullopt; }

  std::function<void()> on_pass;              ///< is called before time passes
  std::function<void()> on_start;             ///< is called when an attempt is started
  std::vector<std::string> started, adopted;  ///< case ids
  std::vector<std::pair<campaign::Handle, campaign::StopLevel>> stops;

 private:
  [[nodiscard]] campaign::Presence presence_of(const campaign::Handle& handle) const {
    if (!system_.answers) return campaign::Presence::kUnknown;
    const auto job = system_.jobs.find(handle);
    return job == system_.jobs.end() ? campaign::Presence::kGone : job->second.state;
  }

  BatchSystem& system_;
  std::set<campaign::Handle> watched_;
  std::vector<std::string> not_submitted_;
};

}  // namespace softwall::test
