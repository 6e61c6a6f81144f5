#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "campaign/launch/slurm_launcher.hpp"
#include "campaign/system/clock.hpp"
#include "solver/case/file_descriptor.hpp"
#include "solver/run_directory/run_files.hpp"
#include "tests/campaign/launch/fake_slurm.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"

/// The launcher with scripts in the place of Slurm's commands; the end-to-end test has the real ones.
namespace softwall::campaign::slurm_tests {

inline constexpr const char* kCase = "0123456789abcdef";

inline SlurmOptions usual_options() {
  SlurmOptions options;
  options.signal_seconds = 120;
  options.start_with = "mpirun";
  return options;
}

class SlurmLauncherTest : public ::testing::Test {
 protected:
  SlurmLauncherTest() {
    launcher_.prepare("/opt/softwall-dns", 0);
    std::filesystem::create_directories(run_.directory);
  }
  [[nodiscard]] LaunchRequest request() const { return {kCase, run_.directory, 1, 2, std::nullopt}; }

  std::optional<EndedAttempt> collect_once(SlurmLauncher& launcher) {
    const auto ended = launcher.collect();
    return ended.empty() ? std::nullopt : std::optional(ended.front());
  }
  /// Calls collect() until it reports an end, for so long at most.
  std::optional<EndedAttempt> wait_for_end(double seconds = 20) {
    const double end = monotonic_seconds() + seconds;
    std::optional<EndedAttempt> ended;
    while (!(ended = collect_once(launcher_)) && monotonic_seconds() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return ended;
  }
  void collect_for(double seconds) { EXPECT_FALSE(wait_for_end(seconds)); }
  [[nodiscard]] Presence presence(const Handle& handle) const {
    return launcher_.presence(run_.directory, handle);
  }
  [[nodiscard]] std::size_t submitted() const { return slurm_.calls("sbatch").size(); }
  [[nodiscard]] FileDescriptor hold_lock() const {
    FileDescriptor lock(open(run_.lock().c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    flock(lock.get(), LOCK_EX);
    return lock;
  }

  test::FakeSlurm slurm_;
  test::TemporaryFolder folder_;
  RunFiles run_{folder_.path() / "cases" / "one-01234567"};
  SlurmOptions options_ = usual_options();
  SlurmLauncher launcher_{options_, test::kQuickPace};
};

}  // namespace softwall::campaign::slurm_tests
