#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "campaign/launch/launcher.hpp"

namespace softwall::test {

/// Attempts that are over as soon as they are asked about: `play` writes what the solver would have left and
/// returns its exit status.
class FakeLauncher final : public campaign::Launcher {
 public:
  using Play = std::function<int(const campaign::LaunchRequest&)>;
  explicit FakeLauncher(Play play) : play_(std::move(play)) {}

  campaign::ProcessIdentity start(const campaign::LaunchRequest& request) override {
    running.push_back(request);
    started.push_back(request);
    int ranks = 0;
    for (const campaign::LaunchRequest& one : running) ranks += one.ranks;
    most_ranks = std::max(most_ranks, ranks);
    return campaign::this_process();
  }
  std::vector<campaign::EndedAttempt> collect() override {
    std::vector<campaign::EndedAttempt> ended;
    for (const campaign::LaunchRequest& request : std::exchange(running, {})) {
      ended.push_back({request.case_id, play_(request)});
    }
    return ended;
  }
  void stop(const std::string& case_id, campaign::StopLevel level) override {
    stops.emplace_back(case_id, level);
  }
  [[nodiscard]] bool idle() const override { return running.empty(); }

  std::vector<campaign::LaunchRequest> running, started;
  std::vector<std::pair<std::string, campaign::StopLevel>> stops;
  int most_ranks = 0;

 private:
  Play play_;
};

}  // namespace softwall::test
