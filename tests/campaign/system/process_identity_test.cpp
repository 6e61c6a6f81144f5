#include "campaign/system/process_identity.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <nlohmann/json.hpp>

#include "tests/support/child_process.hpp"

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

}  // namespace
}  // namespace softwall::campaign
