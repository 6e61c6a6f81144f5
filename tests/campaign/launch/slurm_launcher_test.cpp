#include "campaign/launch/slurm_launcher.hpp"

#include <algorithm>
#include <fstream>
#include <functional>

#include "solver/case/bad_input.hpp"
#include "tests/campaign/launch/slurm_launcher_fixture.hpp"

namespace softwall::campaign {
namespace {

using namespace slurm_tests;

TEST_F(SlurmLauncherTest, FollowsAJobThroughItsLife) {
  const Handle handle = launcher_.start(request());
  EXPECT_EQ(job_of(handle)->number, "1");
  EXPECT_EQ(presence(handle), Presence::kQueued);
  EXPECT_FALSE(launcher_.idle());
  slurm_.move_all("RUNNING");
  EXPECT_EQ(presence(handle), Presence::kRunning);
  EXPECT_FALSE(collect_once(launcher_));
  slurm_.move_all("FAILED", 85 << 8);
  const auto ended = wait_for_end();
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->case_id, kCase);
  EXPECT_EQ(ended->exit_code, 85);
  EXPECT_FALSE(ended->verdict);
  EXPECT_TRUE(launcher_.idle());
  EXPECT_EQ(presence(handle), Presence::kGone);
  EXPECT_EQ(submitted(), 1U);
  EXPECT_FALSE(std::filesystem::exists(job_script(run_.directory)));
}

TEST_F(SlurmLauncherTest, TheIntendedHandleFindsTheJob) {
  const Handle intended = launcher_.intended(request());
  static_cast<void>(launcher_.start(request()));
  SlurmLauncher next(options_, test::kQuickPace);
  EXPECT_EQ(next.presence(run_.directory, intended), Presence::kQueued);
  EXPECT_TRUE(next.adopt(request(), intended));
  slurm_.move_all("COMPLETED");
  const auto ended = collect_once(next);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, 0);
}

TEST_F(SlurmLauncherTest, AnAttemptOfAnotherLauncherIsNotAdopted) {
  EXPECT_FALSE(launcher_.adopt(request(), R"({"pid":12,"host":"here"})"));
  EXPECT_EQ(presence("{}"), Presence::kGone);
}

TEST_F(SlurmLauncherTest, EveryJobIsAskedAboutInOneQuestion) {
  std::vector<AttemptPlace> places;
  for (int i = 0; i < 20; ++i) {
    LaunchRequest one = request();
    one.case_id += std::to_string(i);
    one.run_directory = folder_.path() / "cases" / std::to_string(i);
    std::filesystem::create_directories(one.run_directory);
    places.push_back({one.run_directory, launcher_.start(one)});
  }
  SlurmLauncher patient(options_, {.shortest = 100});
  EXPECT_EQ(patient.presences(places), std::vector<Presence>(20, Presence::kQueued));
  const std::size_t before = slurm_.calls("squeue").size();
  static_cast<void>(launcher_.collect());
  EXPECT_EQ(slurm_.calls("squeue").size(), before + 1);
}

TEST_F(SlurmLauncherTest, WhatSlurmRefusesIsSaidInItsWords) {
  slurm_.play("sbatch", "echo 'allocation failure: Invalid partition name specified' >&2; exit 1");
  try {
    launcher_.prepare("/opt/softwall-dns", 3);
    FAIL() << "not refused";
  } catch (const BadInput& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("a job of 3 ranks"), std::string::npos) << message;
    EXPECT_NE(message.find("Invalid partition name specified"), std::string::npos) << message;
  }
  EXPECT_NE(slurm_.calls("sbatch").front().find("--test-only"), std::string::npos);
}

TEST_F(SlurmLauncherTest, WhatTheClusterCanNeverRunIsRefusedAlsoWhileItsNodesAreDown) {
  slurm_.play("sbatch",
              "echo 'allocation failure: Requested node configuration is not available' >&2; exit 1");
  slurm_.play("sinfo", "echo 'main|1|4|'");
  EXPECT_NO_THROW(launcher_.prepare("/opt/softwall-dns", 4));
  EXPECT_THROW(launcher_.prepare("/opt/softwall-dns", 5), BadInput);
}

TEST_F(SlurmLauncherTest, WhatMayPassIsNoRefusal) {
  for (const char* words : {"Unable to contact slurm controller (connect failure)", "Socket timed out",
                            "Requested node configuration is not available"}) {
    slurm_.play("sbatch", std::string("echo 'allocation failure: ") + words + "' >&2; exit 1");
    EXPECT_NO_THROW(launcher_.prepare("/opt/softwall-dns", 1)) << words;
  }
}

TEST_F(SlurmLauncherTest, MissingCommandsAreNamed) {
  std::filesystem::remove(slurm_.folder() / "bin" / "scancel");
  setenv("PATH", (slurm_.folder() / "bin").c_str(), 1);
  EXPECT_THROW(launcher_.prepare("/opt/softwall-dns", 1), BadInput);
}

TEST_F(SlurmLauncherTest, AJobThatWasAcceptedByAnSbatchThatDiedIsNotSubmittedAgain) {
  for (const char* end : {"kill -9 $$", "exit 1", "sleep 60", "echo surprise"}) {
    SCOPED_TRACE(end);
    const std::size_t before = submitted();
    slurm_.play("sbatch", test::FakeSlurm::kAccept + end);
    const Handle handle = launcher_.start(request());
    EXPECT_NE(presence(handle), Presence::kGone);
    collect_for(0.5);
    EXPECT_EQ(submitted(), before + 1);
    EXPECT_EQ(presence(handle), Presence::kQueued);
    slurm_.move_all("COMPLETED");
    EXPECT_TRUE(wait_for_end());
    slurm_.set_queue({});
  }
}

TEST_F(SlurmLauncherTest, AJobOfWhichNothingIsHeardIsSubmittedAgainOnceTheDoubtIsOver) {
  slurm_.play("sbatch", "kill -9 $$");
  const double begin = monotonic_seconds();
  const Handle handle = launcher_.start(request());
  while (submitted() < 2 && monotonic_seconds() < begin + 20) {
    EXPECT_NE(presence(handle), Presence::kGone);
    collect_for(0.02);
  }
  EXPECT_GE(monotonic_seconds() - begin, test::kQuickPace.doubt);
  EXPECT_EQ(submitted(), 2U);
}

TEST_F(SlurmLauncherTest, ARefusalIsNoFailureButTriedAgainAndToldOnce) {
  slurm_.play("sbatch", "echo 'sbatch: error: QOSMaxSubmitJobPerUserLimit' >&2; exit 1");
  const Handle handle = launcher_.start(request());
  collect_for(0.3);
  EXPECT_GT(submitted(), 1U);
  const auto news = launcher_.news();
  ASSERT_EQ(news.size(), 1U);
  EXPECT_NE(news[0].find("QOSMaxSubmitJobPerUserLimit"), std::string::npos) << news[0];
  slurm_.play("sbatch", test::FakeSlurm::kAccept + "echo $number");
  collect_for(0.3);
  EXPECT_EQ(presence(handle), Presence::kQueued);
  EXPECT_EQ(launcher_.news(), std::vector<std::string>{"Slurm takes jobs again"});
}

TEST_F(SlurmLauncherTest, WhyAJobWaitsIsToldOnceUnlessItIsTheUsual) {
  static_cast<void>(launcher_.start(request()));
  collect_for(0.1);
  EXPECT_TRUE(launcher_.news().empty()) << "Priority";
  slurm_.set_queue({"1|PENDING|0|PartitionTimeLimit|" + job_name(request()) + "|"});
  collect_for(0.1);
  EXPECT_EQ(launcher_.news(),
            std::vector<std::string>{"one-01234567: job 1 waits, says Slurm: PartitionTimeLimit"});
}

TEST_F(SlurmLauncherTest, SilenceAndGarbageAreUnknownAndNoEnd) {
  const Handle handle = launcher_.start(request());
  slurm_.move_all("RUNNING");
  for (const char* answer :
       {"exit 1", "echo garbage", "head -c 20 queue", "sleep 60", "head -c 9999 /dev/urandom"}) {
    SCOPED_TRACE(answer);
    slurm_.play("squeue", answer);
    EXPECT_FALSE(collect_once(launcher_));
    EXPECT_EQ(presence(handle), Presence::kUnknown);
    EXPECT_FALSE(launcher_.news().empty());
    slurm_.play("squeue", "cat queue");
    EXPECT_FALSE(collect_once(launcher_));
    EXPECT_EQ(presence(handle), Presence::kRunning);
    EXPECT_EQ(launcher_.news(), std::vector<std::string>{"Slurm answers again"});
  }
  EXPECT_EQ(submitted(), 1U);
}

TEST_F(SlurmLauncherTest, NothingIsSubmittedWhileSlurmIsSilent) {
  slurm_.play("squeue", "exit 1");
  const Handle handle = launcher_.start(request());
  collect_for(0.2);
  EXPECT_EQ(submitted(), 0U);
  EXPECT_EQ(presence(handle), Presence::kQueued);
  slurm_.play("squeue", "cat queue");
  collect_for(0.2);
  EXPECT_EQ(submitted(), 1U);
}

TEST_F(SlurmLauncherTest, AJobThatVanishedRunsWhileItsSolverHoldsTheLock) {
  const Handle handle = launcher_.start(request());
  slurm_.set_queue({});
  {
    const FileDescriptor lock = hold_lock();
    collect_for(0.6);
    EXPECT_EQ(presence(handle), Presence::kRunning);
  }
  test::write_summary(run_, kCase, 1, "finished", 10, 1.0);
  EXPECT_TRUE(collect_once(launcher_)) << "its own word is enough";
}

TEST_F(SlurmLauncherTest, AJobThatVanishedIsGoneWhenNothingMovesAnyMore) {
  static_cast<void>(launcher_.start(request()));
  slurm_.set_queue({});
  const double begin = monotonic_seconds();
  double moved = begin;
  std::optional<EndedAttempt> ended;
  while (!ended && monotonic_seconds() < begin + 1) {
    std::ofstream(run_.log(), std::ios::app) << "step\n";
    moved = monotonic_seconds();
    ended = wait_for_end(0.02);
  }
  if (!ended) ended = wait_for_end();
  EXPECT_GT(monotonic_seconds() - moved, test::kQuickPace.quiet) << "not while its log grows";
  ASSERT_TRUE(ended);
  ASSERT_TRUE(ended->verdict);
  EXPECT_EQ(ended->verdict->outcome, AttemptOutcome::kLost);
}

TEST_F(SlurmLauncherTest, TheAccountingIsAskedAboutAJobThatVanished) {
  static_cast<void>(launcher_.start(request()));
  const std::string name = job_name(request());
  slurm_.set_queue({});
  slurm_.play("sacct", "echo '1|OUT_OF_MEMORY|0:125|" + name + "'");
  const auto ended = wait_for_end();
  ASSERT_TRUE(ended && ended->verdict);
  EXPECT_EQ(ended->verdict->outcome, AttemptOutcome::kOutOfMemory);
}

TEST_F(SlurmLauncherTest, ANodeThatFailedMayStillComputeForAWhile) {
  static_cast<void>(launcher_.start(request()));
  slurm_.move_all("NODE_FAIL");
  {
    const FileDescriptor lock = hold_lock();
    collect_for(0.6);
  }
  const auto ended = wait_for_end();
  ASSERT_TRUE(ended && ended->verdict);
  EXPECT_EQ(ended->verdict->outcome, AttemptOutcome::kNodeFailure);
}

TEST_F(SlurmLauncherTest, SaysWhySlurmEndedAJob) {
  const std::vector<std::pair<std::string, AttemptOutcome>> kEnds = {
      {"TIMEOUT", AttemptOutcome::kTimeout},
      {"CANCELLED", AttemptOutcome::kKilled},
      {"PREEMPTED", AttemptOutcome::kNodeFailure}};
  for (const auto& [state, outcome] : kEnds) {
    SCOPED_TRACE(state);
    static_cast<void>(launcher_.start(request()));
    slurm_.move_all(state);
    const auto ended = wait_for_end();
    ASSERT_TRUE(ended && ended->verdict);
    EXPECT_EQ(ended->verdict->outcome, outcome);
    slurm_.set_queue({});
  }
  static_cast<void>(launcher_.start(request()));
  slurm_.move_all("FAILED", 53);
  const auto ended = wait_for_end();
  ASSERT_TRUE(ended && ended->verdict);
  EXPECT_NE(ended->verdict->reason.find("could not write its log"), std::string::npos);
}

TEST_F(SlurmLauncherTest, OfTwoJobsOfOneNameTheOneThatWaitsIsCancelled) {
  const Handle handle = launcher_.start(request());
  const std::string name = job_name(request());
  slurm_.set_queue({"1|RUNNING|0|None|" + name + "|", "7|PENDING|0|Dependency|" + name + "|"});
  EXPECT_EQ(presence(handle), Presence::kRunning);
  EXPECT_FALSE(collect_once(launcher_));
  EXPECT_EQ(slurm_.calls("scancel"), std::vector<std::string>{"--state=PENDING 7"});
  slurm_.set_queue({"1|COMPLETED|0|None|" + name + "|", "7|CANCELLED|0|None|" + name + "|"});
  EXPECT_TRUE(collect_once(launcher_));
}

TEST_F(SlurmLauncherTest, AFinishedAttemptThatSlurmQueuesAgainIsCancelled) {
  static_cast<void>(launcher_.start(request()));
  test::write_summary(run_, kCase, 1, "finished", 10, 1.0);
  EXPECT_FALSE(collect_once(launcher_));
  ASSERT_FALSE(slurm_.calls("scancel").empty());
  slurm_.move_all("CANCELLED");
  EXPECT_TRUE(collect_once(launcher_));
}

TEST_F(SlurmLauncherTest, AnInterruptedAttemptThatIsQueuedAgainIsLeftAlone) {
  static_cast<void>(launcher_.start(request()));
  test::write_summary(run_, kCase, 1, "interrupted", 10, 0.5);
  EXPECT_FALSE(collect_once(launcher_));
  EXPECT_TRUE(slurm_.calls("scancel").empty());
}

TEST_F(SlurmLauncherTest, AScriptThatIsGoneIsNoEndOfAnAttemptThatWasStartedHere) {
  const Handle handle = launcher_.start(request());
  std::filesystem::remove(job_script(run_.directory));
  EXPECT_EQ(presence(handle), Presence::kQueued);
  EXPECT_FALSE(collect_once(launcher_));
}

TEST_F(SlurmLauncherTest, WhatWasNotAcceptedIsTakenBack) {
  static_cast<void>(launcher_.start(request()));
  EXPECT_TRUE(launcher_.take_back().empty()) << "it goes on without softwall";
  slurm_.play("sbatch", "echo 'sbatch: error: QOSMaxSubmitJobPerUserLimit' >&2; exit 1");
  LaunchRequest other = request();
  other.case_id = "another";
  other.run_directory = folder_.path() / "cases" / "another-01234567";
  std::filesystem::create_directories(other.run_directory);
  const Handle handle = launcher_.start(other);
  EXPECT_EQ(launcher_.take_back(), std::vector<std::string>{"another"});
  SlurmLauncher next(options_, test::kQuickPace);
  EXPECT_EQ(next.presence(other.run_directory, handle), Presence::kGone);
  EXPECT_FALSE(launcher_.idle()) << "the first is still there";
}

TEST_F(SlurmLauncherTest, SubmittingManyJobsIsDoneInPartsSoThatSoftwallCanLeave) {
  SlurmPace pace = test::kQuickPace;
  pace.submitting = 0.0;
  SlurmLauncher launcher(options_, pace);
  launcher.prepare("/opt/softwall-dns", 0);
  slurm_.play("squeue", "exit 1");  // so that they come together
  for (const char* name : {"a", "b", "c"}) {
    LaunchRequest one = request();
    one.case_id = name;
    one.run_directory = folder_.path() / "cases" / name;
    std::filesystem::create_directories(one.run_directory);
    static_cast<void>(launcher.start(one));
  }
  slurm_.play("squeue", "cat queue");
  for (const std::size_t parts : {1U, 2U, 3U}) {
    EXPECT_TRUE(launcher.collect().empty());
    EXPECT_EQ(submitted(), parts);
  }
}

TEST_F(SlurmLauncherTest, SaysForHowLongAJobWouldAsk) {
  options_.time_limit_minutes = 600;
  LaunchRequest one = request();
  one.needed_seconds = 3600;
  EXPECT_EQ(SlurmLauncher(options_).job_minutes(one), time_limit(one, options_));
  EXPECT_FALSE(launcher_.job_minutes(one)) << "the partition's limit is not known";
}

TEST_F(SlurmLauncherTest, StopsByName) {
  const Handle handle = launcher_.start(request());
  launcher_.stop(run_.directory, handle, StopLevel::kTerminate);
  ASSERT_EQ(slurm_.calls("scancel").size(), 1U);
  EXPECT_TRUE(slurm_.calls("scancel")[0].ends_with("--name=" + job_name(request())));
  launcher_.stop(run_.directory, "of somebody else", StopLevel::kKill);
  EXPECT_EQ(slurm_.calls("scancel").size(), 1U);
}

}  // namespace
}  // namespace softwall::campaign
