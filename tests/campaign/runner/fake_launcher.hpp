#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "campaign/launcher.hpp"

namespace softwall::campaign::test {

/// Attempts that are over as soon as they are asked about: `play` writes what the solver would have left and
/// returns its exit status.
class FakeLauncher final : public Launcher {
 public:
  using Play = std::function<int(const LaunchRequest&)>;
  explicit FakeLauncher(Play play) : play_(std::move(play)) {}

  ProcessIdentity start(const LaunchRequest& request) override {
    running.push_back(request);
    started.push_back(request);
    int ranks = 0;
    for (const LaunchRequest& one : running) ranks += one.ranks;
    most_ranks = std::max(most_ranks, ranks);
    return this_process();
  }
  std::vector<EndedAttempt> collect() override {
    std::vector<EndedAttempt> ended;
    for (const LaunchRequest& request : std::exchange(running, {})) {
      ended.push_back({request.case_id, play_(request)});
    }
    return ended;
  }
  void stop(const std::string& case_id, StopLevel level) override { stops.emplace_back(case_id, level); }
  [[nodiscard]] bool idle() const override { return running.empty(); }

  std::vector<LaunchRequest> running, started;
  std::vector<std::pair<std::string, StopLevel>> stops;
  int most_ranks = 0;

 private:
  Play play_;
};

}  // namespace softwall::campaign::test
