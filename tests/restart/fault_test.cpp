#include <gtest/gtest.h>
#include <sys/mount.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "solver/case/atomic_file.hpp"
#include "solver/output/watchdog.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "tests/restart/solver_run.hpp"

// Whatever goes wrong: one clear message, the right exit code, nothing lost.
namespace softwall::support {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

bool newest_is_valid(const SolverRun& run) {
  const auto file = run.newest_checkpoint();
  return !file.empty() && verify_checkpoint(file, run.summary().at("case_id")).valid;
}

TEST(DamagedCheckpoint, IsNamedAndTheOneBeforeIsUsed) {
  json definition = elastic_case(20);
  definition["run"]["checkpoint_steps"] = 8;
  const SolverRun whole(definition), run(definition);
  ASSERT_EQ(whole.run(2).code, 0);
  ASSERT_EQ(run.run(2).code, 0);
  damage(run.newest_checkpoint());
  const Ended ended = run.run(2);
  ASSERT_EQ(ended.code, 0) << ended.output;
  EXPECT_NE(ended.output.find("passing over checkpoint-000000020.h5"), std::string::npos) << ended.output;
  EXPECT_EQ(run.summary().at("resumed_from"), "checkpoints/checkpoint-000000016.h5");
  expect_same_results(run, whole);
}

TEST(DamagedCheckpoint, AllOfThemAreRefused) {
  json definition = rigid_case(20);
  definition["run"]["checkpoint_steps"] = 8;
  const SolverRun run(definition);
  ASSERT_EQ(run.run(2).code, 0);
  for (const auto& file : checkpoint_ladder(run.files())) damage(file);
  const Ended ended = run.run(2);
  EXPECT_EQ(ended.code, 77);
  EXPECT_NE(ended.output.find("checkpoint-000000016.h5"), std::string::npos) << ended.output;
  EXPECT_NE(ended.output.find("checkpoint-000000020.h5"), std::string::npos) << ended.output;
  EXPECT_EQ(checkpoint_ladder(run.files()).size(), 2U);
  EXPECT_EQ(run.summary().at("outcome"), "finished");  // what was once proved stays so
}

TEST(FinishedCase, IsReportedAgainWithoutAStep) {
  const SolverRun run(rigid_case(9));
  ASSERT_EQ(run.run(2).code, 0);
  const std::string statistics = contents(run.files().statistics());
  fs::remove(run.files().summary());
  fs::remove(run.files().statistics());
  ASSERT_EQ(run.run(2, "--attempt 5").code, 0);
  EXPECT_EQ(run.summary().at("outcome"), "finished");
  EXPECT_EQ(run.summary().at("attempt"), 5);
  EXPECT_EQ(run.summary().at("attempt_steps"), 0);
  EXPECT_EQ(contents(run.files().statistics()), statistics);
}

TEST(SecondSolver, IsRefusedAndTheFirstGoesOn) {
  SolverRun run(rigid_case(1000000));
  const pid_t mpirun = run.start(1);
  ASSERT_TRUE(run.wait_for_step(0));
  const int status = std::system((std::string(SOFTWALL_MPIEXEC) + " -n 1 --oversubscribe '" + SOFTWALL_DNS +
                                  "' '" + run.files().directory.string() + "' >'" +
                                  (run.files().directory / "second.log").string() + "' 2>&1")
                                     .c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_NE(contents(run.files().directory / "second.log").find("another solver is running"),
            std::string::npos);
  ::kill(mpirun, SIGUSR1);
  EXPECT_EQ(run.wait().code, 85);
}

TEST(Divergence, IsReportedAndTheLastFiniteCheckpointStays) {
  json definition = rigid_case(1000);
  definition["physics"]["time_step"]["fixed_dt"] = 1.0;
  definition["physics"]["grid"] = {{"nx", 16}, {"ny_fluid", 24}, {"nz", 16}};
  definition["run"]["checkpoint_steps"] = 1;
  definition["run"]["end_time"] = 1000;
  const SolverRun run(definition);
  const Ended ended = run.run(2);
  EXPECT_EQ(ended.code, 76) << ended.output;
  EXPECT_NE(ended.output.find("diverged at step"), std::string::npos) << ended.output;
  EXPECT_EQ(run.summary().at("outcome"), "diverged");
  EXPECT_TRUE(newest_is_valid(run));
}

TEST(BadCase, SaysEverythingThatIsWrong) {
  json definition = elastic_case(10);
  definition["physics"]["solid"]["G"] = -1;
  definition["physics"]["grid"]["nxx"] = 8;
  const SolverRun run(definition);
  const Ended ended = run.run(2);
  EXPECT_EQ(ended.code, 78);
  EXPECT_NE(ended.output.find("/physics/solid/G"), std::string::npos) << ended.output;
  EXPECT_NE(ended.output.find("nxx"), std::string::npos) << ended.output;
}

TEST(BadCase, NoCaseAtAll) {
  const SolverRun run;
  const Ended ended = run.run(2);
  EXPECT_EQ(ended.code, 78);
  EXPECT_NE(ended.output.find("case.json"), std::string::npos) << ended.output;
}

TEST(BadCase, MoreRanksThanTheGridCanFeed) {
  json definition = rigid_case(10);
  definition["physics"]["grid"] = {{"nx", 4}, {"ny_fluid", 8}, {"nz", 4}};
  const SolverRun run(definition);
  const Ended ended = run.run(3);
  EXPECT_EQ(ended.code, 78);
  EXPECT_NE(ended.output.find("3 ranks"), std::string::npos) << ended.output;
}

json case_from(const SolverRun& precursor, const fs::path& checkpoint) {
  json definition = elastic_case(6);
  definition["physics"]["initial"] = {{"type", "precursor"},
                                      {"precursor", precursor.summary().at("case_id")},
                                      {"precursor_time", precursor.summary().at("time")}};
  definition["run"]["initial_checkpoint"] = checkpoint.string();
  return definition;
}

TEST(Precursor, StartsAnElasticCaseAndIsNotNeededAgain) {
  const SolverRun precursor(rigid_case(10));
  ASSERT_EQ(precursor.run(2).code, 0);
  const SolverRun whole(case_from(precursor, precursor.newest_checkpoint()));
  ASSERT_EQ(whole.run(2).code, 0);

  const SolverRun run(case_from(precursor, precursor.newest_checkpoint()));
  ASSERT_EQ(run.run(2, "--wall-seconds 0.001").code, 85);
  fs::remove(precursor.newest_checkpoint());
  ASSERT_EQ(run.run(2).code, 0);
  expect_same_results(run, whole);
}

TEST(Precursor, MissingOrOfAnotherCaseOrDamagedIsRefused) {
  const SolverRun precursor(rigid_case(10));
  ASSERT_EQ(precursor.run(2).code, 0);
  const SolverRun missing(case_from(precursor, "nowhere.h5"));
  const Ended no_file = missing.run(2);
  EXPECT_EQ(no_file.code, 78);
  EXPECT_NE(no_file.output.find("nowhere.h5"), std::string::npos) << no_file.output;

  json definition = case_from(precursor, precursor.newest_checkpoint());
  definition["physics"]["initial"]["precursor"] = "00000000deadbeef";
  EXPECT_EQ(SolverRun(definition).run(2).code, 78);

  damage(precursor.newest_checkpoint());
  const SolverRun run(case_from(precursor, precursor.newest_checkpoint()));
  const Ended damaged = run.run(2);
  EXPECT_EQ(damaged.code, 77);
  EXPECT_NE(damaged.output.find("digest"), std::string::npos) << damaged.output;
  EXPECT_EQ(run.summary().at("outcome"), "failed");
}

/// A small file system over a run's folder; needs root.
class SmallDisk {
 public:
  SmallDisk(const fs::path& folder, const char* options) : folder_(folder) {
    mounted_ = ::mount("tmpfs", folder.c_str(), "tmpfs", 0, options) == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  explicit operator bool() const { return mounted_; }
  bool change(unsigned long flags, const char* options) const {
    return ::mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT | flags, options) == 0;
  }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

TEST(FullDisk, EndsWith75AndTheLastCheckpointResumes) {
  json definition = rigid_case(30);
  definition["run"]["checkpoint_steps"] = 10;
  definition["run"]["keep_checkpoints"] = 100;
  const SolverRun whole(definition), run;
  ASSERT_EQ(whole.run(2).code, 0);
  const auto bytes = fs::file_size(whole.newest_checkpoint());
  const std::string two_and_a_half = "size=" + std::to_string(bytes * 5 / 2);
  const SmallDisk disk(run.files().directory, two_and_a_half.c_str());
  if (!disk) GTEST_SKIP() << "mounting a small file system needs root";
  run.write_case(definition);
  const Ended full = run.run(2);
  EXPECT_EQ(full.code, 75) << full.output;
  ASSERT_FALSE(run.newest_checkpoint().empty());
  EXPECT_TRUE(verify_checkpoint(run.newest_checkpoint(), whole.summary().at("case_id")).valid);
  ASSERT_TRUE(disk.change(0, "size=100m"));
  const Ended ended = run.run(2);
  EXPECT_EQ(ended.code, 0) << ended.output;
  expect_same_results(run, whole);
}

TEST(AttemptThatWasReplaced, LeavesWithoutAWord) {
  json definition = rigid_case(20);
  const SolverRun whole(definition), run(definition);
  ASSERT_EQ(whole.run(1, "--attempt 2").code, 0);
  std::ofstream(run.files().run_record())
      << json{{"format", 1}, {"case_id", whole.summary().at("case_id")}, {"attempt", 2}, {"started", ""}};
  const Ended early = run.run(1, "--attempt 1");
  EXPECT_EQ(early.code, 1);
  EXPECT_NE(early.output.find("attempt 2 has taken the place of this one, 1"), std::string::npos)
      << early.output;
  EXPECT_FALSE(fs::exists(run.files().summary()));
  EXPECT_TRUE(run.newest_checkpoint().empty());
  EXPECT_EQ(run.run(1, "--attempt 2").code, 0);
  expect_same_results(run, whole);
  EXPECT_EQ(run.run(1).code, 0) << "a person who starts the solver by hand knows what he does";
}

TEST(AttemptThatWasReplaced, LeavesBeforeItsNextCheckpointWithoutAWord) {
  json definition = rigid_case(1000000);
  definition["run"]["checkpoint_steps"] = 50;
  SolverRun run(definition);
  run.start(2, "--attempt 1");
  ASSERT_TRUE(run.wait_for_step(50));
  const json record{{"format", 1},
                    {"case_id", json::parse(contents(run.files().status())).at("case_id")},
                    {"attempt", 2},
                    {"started", ""}};
  write_atomically(run.files().run_record(), record.dump());
  const Ended late = run.wait();
  EXPECT_EQ(late.code, 1);
  EXPECT_NE(late.output.find("attempt 2 has taken the place of this one, 1"), std::string::npos)
      << late.output;
  EXPECT_FALSE(fs::exists(run.files().summary()));
}

TEST(ReadOnlyFolder, IsNamed) {
  const SolverRun run;
  const SmallDisk disk(run.files().directory, "size=10m");
  if (!disk) GTEST_SKIP() << "mounting a small file system needs root";
  run.write_case(rigid_case(10));
  ASSERT_TRUE(disk.change(MS_RDONLY, "size=10m"));
  const std::string log = fs::temp_directory_path() / ("softwall-read-only-" + std::to_string(::getpid()));
  const int status = std::system((std::string(SOFTWALL_MPIEXEC) + " -n 2 --oversubscribe '" + SOFTWALL_DNS +
                                  "' '" + run.files().directory.string() + "' >'" + log + "' 2>&1")
                                     .c_str());
  EXPECT_EQ(WEXITSTATUS(status), 75);
  EXPECT_NE(contents(log).find("solver.lock"), std::string::npos) << contents(log);
  fs::remove(log);
}

TEST(FileSizeLimit, EndsWith75) {
  json definition = rigid_case(10);  // a checkpoint of 25 MB; MPI's own files must stay below the limit
  definition["physics"]["grid"] = {{"nx", 128}, {"ny_fluid", 64}, {"nz", 96}};
  const SolverRun run(definition);
  const Ended ended = run.run(2, "--wall-seconds 0.001", "ulimit -f 40000");  // blocks of 512 bytes
  EXPECT_EQ(ended.code, 75) << ended.output;
  EXPECT_TRUE(run.newest_checkpoint().empty());
}

TEST(Watchdog, EndsAProcessThatHangs) {
  EXPECT_EXIT(
      {
        const output::Watchdog watchdog(1);
        for (;;) ::pause();
      },
      testing::ExitedWithCode(75), "hangs");
}

TEST(Watchdog, LeavesAloneWhatEndsInTime) {
  { const output::Watchdog watchdog(1); }
  ::usleep(1'200'000);
  EXPECT_GE(output::Watchdog::seconds_for(0), 60U);
  EXPECT_GT(output::Watchdog::seconds_for(std::int64_t{1} << 40), 3600U);
}

}  // namespace
}  // namespace softwall::support
