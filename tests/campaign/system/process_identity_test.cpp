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

TEST(ProcessIdentity, SurvivesTheRoundTripThroughJson) {
  const ProcessIdentity here = this_process();
  EXPECT_EQ(nlohmann::json::parse(nlohmann::json(here).dump()).get<ProcessIdentity>(), here);
}

TEST(ProcessIdentity, AnEndedProcessHasEndedEvenBeforeItIsWaitedFor) {
  test::ChildProcess child(sleep_forever);
  EXPECT_FALSE(has_ended(child.pid()));
  child.send(SIGKILL);
  siginfo_t info{};
  waitid(P_PID, static_cast<id_t>(child.pid()), &info, WEXITED | WNOWAIT);
  EXPECT_TRUE(has_ended(child.pid()));
  child.wait();
  EXPECT_TRUE(has_ended(child.pid()));
}

}  // namespace
}  // namespace softwall::campaign
