#include "campaign/system/process_identity.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

int sleep_forever() {
  while (true) pause();
}

TEST(ProcessIdentity, FindsItselfAlive) { EXPECT_TRUE(is_alive(this_process())); }

TEST(ProcessIdentity, SurvivesTheRoundTripThroughJson) {
  const ProcessIdentity here = this_process();
  EXPECT_EQ(nlohmann::json::parse(nlohmann::json(here).dump()).get<ProcessIdentity>(), here);
}

TEST(ProcessIdentity, ANumberUsedAgainIsNotTheSameProcess) {
  ProcessIdentity later = this_process();
  later.start_ticks += 1;
  EXPECT_FALSE(is_alive(later));
}

TEST(ProcessIdentity, AProcessOfAnotherBootOrHostIsNotAlive) {
  ProcessIdentity rebooted = this_process();
  rebooted.boot_id = "00000000-0000-0000-0000-000000000000";
  EXPECT_FALSE(is_alive(rebooted));
  ProcessIdentity elsewhere = this_process();
  elsewhere.host += ".elsewhere";
  EXPECT_FALSE(is_alive(elsewhere));
}

TEST(ProcessIdentity, AnEndedProcessIsNotAliveEvenBeforeItIsWaitedFor) {
  test::ChildProcess child(sleep_forever);
  const ProcessIdentity identity = identify(child.pid());
  EXPECT_TRUE(is_alive(identity));
  child.send(SIGKILL);
  siginfo_t info{};
  waitid(P_PID, static_cast<id_t>(child.pid()), &info, WEXITED | WNOWAIT);
  EXPECT_FALSE(is_alive(identity));
  child.wait();
  EXPECT_FALSE(is_alive(identity));
}

TEST(ProcessesOf, FindsExactlyTheProcessesOfARunDirectory) {
  const test::TemporaryFolder folder;
  const auto directory = folder.path() / "case";
  // The environment of a process is what it was given at exec.
  const auto start = [](const std::filesystem::path& run_directory) {
    return [run_directory] {
      setenv(kRunDirectoryVariable, run_directory.c_str(), 1);
      execl("/bin/sleep", "sleep", "60", nullptr);
      return 127;
    };
  };
  const test::ChildProcess ours(start(directory));
  const test::ChildProcess neighbour(start(folder.path() / "case2"));
  std::vector<pid_t> found;
  for (int i = 0; i < 100 && found.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    found = processes_of(directory);
  }
  EXPECT_EQ(found, std::vector<pid_t>{ours.pid()});
}

}  // namespace
}  // namespace softwall::campaign
