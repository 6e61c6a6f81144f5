#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "campaign/launch/launcher.hpp"

namespace softwall::test {

/// A launcher of which a test says only what matters to it: nothing is ever found that it has not started.
class LauncherWithoutMemory : public campaign::Launcher {
 public:
  void prepare(const std::filesystem::path&, int) override {}
  bool adopt(const campaign::LaunchRequest&, const campaign::Handle&) override { return false; }
  [[nodiscard]] std::vector<campaign::Presence> presences(
      const std::vector<campaign::AttemptPlace>& places) const override {
    return std::vector<campaign::Presence>(places.size(), campaign::Presence::kGone);
  }
  void clean_up(const std::filesystem::path&) override {}
  [[nodiscard]] std::optional<int> capacity() const override { return 2; }
};

/// Attempts that are over as soon as they are asked about: `play` writes what the solver would have left and
/// returns its exit status.
class FakeLauncher final : public LauncherWithoutMemory {
 public:
  using Play = std::function<int(const campaign::LaunchRequest&)>;
  explicit FakeLauncher(Play play) : play_(std::move(play)) {}

  campaign::Handle start(const campaign::LaunchRequest& request) override {
    running.push_back(request);
    started.push_back(request);
    int ranks = 0;
    for (const campaign::LaunchRequest& one : running) ranks += one.ranks;
    most_ranks = std::max(most_ranks, ranks);
    return "attempt " + std::to_string(request.attempt);
  }
  std::vector<campaign::EndedAttempt> collect() override {
    std::vector<campaign::EndedAttempt> ended;
    for (const campaign::LaunchRequest& request : std::exchange(running, {})) {
      ended.push_back({request.case_id, play_(request)});
    }
    return ended;
  }
  void stop(const std::filesystem::path&, const campaign::Handle& handle,
            campaign::StopLevel level) override {
    stops.emplace_back(handle, level);
  }
  [[nodiscard]] bool idle() const override { return running.empty(); }

  std::vector<campaign::LaunchRequest> running, started;
  std::vector<std::pair<campaign::Handle, campaign::StopLevel>> stops;
  int most_ranks = 0;

 private:
  Play play_;
};

/// Attempts that are looked at again and again: `look` writes what the solver leaves meanwhile, and returns
/// its exit status once it has ended.
class WatchedLauncher final : public LauncherWithoutMemory {
 public:
  using Look = std::function<std::optional<int>(const campaign::LaunchRequest&)>;
  explicit WatchedLauncher(Look look) : look_(std::move(look)) {}

  campaign::Handle start(const campaign::LaunchRequest& request) override {
    running_.push_back(request);
    started.push_back(request);
    return request.case_id;
  }
  std::vector<campaign::EndedAttempt> collect() override {
    std::vector<campaign::EndedAttempt> ended;
    std::erase_if(running_, [&](const campaign::LaunchRequest& request) {
      const auto code = look_(request);
      if (code) ended.push_back({request.case_id, *code});
      return code.has_value();
    });
    return ended;
  }
  void stop(const std::filesystem::path&, const campaign::Handle& handle,
            campaign::StopLevel level) override {
    stops.emplace_back(handle, level);
  }
  [[nodiscard]] bool idle() const override { return running_.empty(); }

  std::vector<campaign::LaunchRequest> started;
  std::vector<std::pair<campaign::Handle, campaign::StopLevel>> stops;

 private:
  Look look_;
  std::vector<campaign::LaunchRequest> running_;
};

}  // namespace softwall::test
