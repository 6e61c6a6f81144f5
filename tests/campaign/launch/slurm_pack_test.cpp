#include "campaign/launch/slurm_pack.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <thread>

#include "campaign/launch/slurm_job.hpp"
#include "campaign/launch/slurm_launcher.hpp"
#include "tests/campaign/launch/fake_slurm.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"

/// Several cases in one job: its script is run by the shell that would run it on a cluster.
namespace softwall::campaign {
namespace {

using namespace std::chrono_literals;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Pack : public ::testing::Test {
 protected:
  /// A case whose script, in the place of mpirun, does this.
  LaunchRequest add(const std::string& name, const std::string& body, int ranks = 2) {
    LaunchRequest one{name, folder_.path() / "walls" / "cases" / name, 1, ranks, std::nullopt};
    std::filesystem::create_directories(one.run_directory);
    bodies_.push_back(body);
    cases_.push_back(one);
    return one;
  }
  /// Starts the job's script. It leads a session of its own, as a job does.
  pid_t start() {
    for (std::size_t i = 0; i < cases_.size(); ++i)
      std::ofstream(job_script(cases_[i].run_directory)) << "#!/bin/sh\n"
                                                         << job_line(pack_name(cases_)) << bodies_[i] << "\n";
    const auto script = pack_script(cases_.front().run_directory);
    std::ofstream(script) << pack_text(cases_);
    const pid_t pid = fork();
    if (pid == 0) {
      setsid();
      execl("/bin/sh", "sh", script.c_str(), nullptr);
      _exit(127);
    }
    return job_ = pid;
  }
  void TearDown() override {
    if (job_ > 0) kill(-job_, SIGKILL);  // of a test that has failed, something may be left
  }
  static int wait_for(pid_t pid) {
    int status = 0;
    waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  static void wait_until(const std::function<bool()>& condition) {
    for (int n = 0; n < 2000 && !condition(); ++n) std::this_thread::sleep_for(10ms);
    EXPECT_TRUE(condition());
  }
  [[nodiscard]] std::optional<int> end_of(std::size_t i) const {
    return packed_exit_code(cases_[i].run_directory, 1);
  }
  [[nodiscard]] std::string log_of(std::size_t i) const {
    return text_of(cases_[i].run_directory / "solver.log");
  }

  pid_t job_ = 0;
  test::TemporaryFolder folder_;
  std::vector<LaunchRequest> cases_;
  std::vector<std::string> bodies_;
};

constexpr const char* kUntilAsked =
    "trap 'echo asked; exit 85' USR1; echo begun; while :; do sleep 0.05; done";

TEST_F(Pack, RunsItsCasesSideBySideAndNotesHowEachEnded) {
  add("a", "while [ ! -e ../b/there ]; do sleep 0.05; done; echo a; exit 3");
  add("b", "touch there; while [ ! -e ../a/job.end ]; do sleep 0.05; done; echo b; kill -9 $$");
  EXPECT_EQ(wait_for(start()), 0);
  EXPECT_EQ(end_of(0), 3);
  EXPECT_EQ(end_of(1), 128 + SIGKILL);
  EXPECT_EQ(log_of(0), "a\n");
  EXPECT_EQ(log_of(1).substr(0, 2), "b\n");
  EXPECT_FALSE(packed_exit_code(cases_[0].run_directory, 2)) << "of another attempt";
}

TEST_F(Pack, PassesTheRequestToCheckpointOnToAll) {
  add("a", kUntilAsked);
  add("b", kUntilAsked);
  const pid_t job = start();
  wait_until([&] { return log_of(0) == "begun\n" && log_of(1) == "begun\n"; });
  kill(job, SIGUSR1);
  EXPECT_EQ(wait_for(job), 0);
  for (const std::size_t i : {0, 1}) {
    EXPECT_EQ(end_of(i), 85);
    EXPECT_EQ(log_of(i), "begun\nasked\n");
  }
}

TEST_F(Pack, AsksOneCaseAndLeavesTheOthersAlone) {
  add("a", kUntilAsked);
  add("b", kUntilAsked);
  const pid_t job = start();
  wait_until([&] { return log_of(0) == "begun\n" && log_of(1) == "begun\n"; });
  ask_packed(cases_[0].run_directory, StopLevel::kCheckpoint);
  wait_until([&] { return end_of(0).has_value(); });
  EXPECT_EQ(end_of(0), 85);
  EXPECT_FALSE(end_of(1));
  ask_packed(cases_[1].run_directory, StopLevel::kKill);
  EXPECT_EQ(wait_for(job), 0);
  EXPECT_EQ(end_of(1), 128 + SIGKILL);
}

TEST_F(Pack, OutlivesTheTermThatReachesEveryProcessAndNotesTheEnds) {
  add("a", "echo begun; while :; do sleep 0.05; done");
  add("b", "trap 'exit 1' TERM; echo begun; while :; do sleep 0.05; done");  // as mpirun does
  const pid_t job = start();
  wait_until([&] { return log_of(0) == "begun\n" && log_of(1) == "begun\n"; });
  kill(-job, SIGTERM);
  EXPECT_EQ(wait_for(job), 0);
  EXPECT_EQ(end_of(0), 128 + SIGTERM);
  EXPECT_EQ(end_of(1), 128 + SIGTERM);
}

TEST_F(Pack, PassesOverACaseThatRunsElsewhereByNowOrWasTakenBack) {
  add("a", "echo a");
  add("b", "echo b");
  add("c", "echo c");
  EXPECT_EQ(wait_for(start()), 0);
  for (const LaunchRequest& one : cases_) remove_pack_files(one.run_directory);
  std::filesystem::remove(job_script(cases_[0].run_directory));
  std::ofstream(job_script(cases_[1].run_directory)) << "#!/bin/sh\n"
                                                     << job_line("softwall.other") << "echo b\n";
  const auto script = folder_.write("jobs.sh", pack_text(cases_));
  EXPECT_EQ(WEXITSTATUS(std::system(("sh " + script.string()).c_str())), 0);
  EXPECT_EQ(log_of(0), "a\n");
  EXPECT_EQ(log_of(1), "b\n");
  EXPECT_EQ(log_of(2), "c\nc\n");
}

TEST_F(Pack, IsNamedAfterItsAttemptsAndAsksForAllOfThem) {
  add("a", "", 2);
  const std::string alone = pack_name(cases_);
  EXPECT_EQ(alone, job_name(cases_[0]));
  add("b", "", 3);
  const std::string both = pack_name(cases_);
  EXPECT_TRUE(both.starts_with("softwall.walls.2-cases.")) << both;
  EXPECT_EQ(together(cases_).ranks, 5);
  cases_[0].needed_seconds = 10;
  EXPECT_FALSE(together(cases_).needed_seconds) << "of one case it is not known";
  cases_[1].needed_seconds = 20;
  EXPECT_EQ(together(cases_).needed_seconds, 20.0);
  cases_[1].attempt = 2;
  EXPECT_NE(pack_name(cases_), both);
}

class PackedLauncher : public ::testing::Test {
 protected:
  PackedLauncher() { launcher_.prepare("/opt/softwall-dns", 0); }
  LaunchRequest request(const std::string& name) {
    LaunchRequest one{name, folder_.path() / "walls" / "cases" / name, 1, 2, std::nullopt};
    std::filesystem::create_directories(one.run_directory);
    return one;
  }
  static SlurmOptions options() {
    SlurmOptions options;
    options.signal_seconds = 120;
    options.start_with = "mpirun";
    options.cases_per_job = 2;
    return options;
  }
  test::FakeSlurm slurm_;
  test::TemporaryFolder folder_;
  SlurmLauncher launcher_{options(), test::kQuickPace};
};

TEST_F(PackedLauncher, SubmitsFullJobsAtOnceAndTheRestWhenNothingElseIsStarted) {
  std::vector<Handle> handles;
  for (const char* name : {"a", "b", "c"}) handles.push_back(launcher_.start(request(name)));
  EXPECT_EQ(slurm_.calls("sbatch").size(), 1U);
  EXPECT_TRUE(launcher_.collect().empty());
  EXPECT_EQ(slurm_.calls("sbatch").size(), 1U) << "one that ends soon may come with it";
  std::this_thread::sleep_for(600ms);
  EXPECT_TRUE(launcher_.collect().empty());
  const auto calls = slurm_.calls("sbatch");
  ASSERT_EQ(calls.size(), 2U);
  for (const char* word : {"--ntasks=4", "--nodes=1", "2-cases", "jobs.sh"})
    EXPECT_NE(calls[0].find(word), std::string::npos) << word << " in " << calls[0];
  EXPECT_NE(calls[1].find("--ntasks=2"), std::string::npos) << calls[1];
  EXPECT_EQ(calls[1].find("--nodes"), std::string::npos) << "one alone is a job as any other";
  SlurmLauncher next(options(), test::kQuickPace);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(next.presence(request(std::string(1, static_cast<char>('a' + i))).run_directory, handles[i]),
              Presence::kQueued)
        << "found by whoever comes after";
}

TEST_F(PackedLauncher, ACaseEndsBeforeItsJobDoes) {
  const LaunchRequest a = request("a"), b = request("b");
  const Handle of_a = launcher_.start(a), of_b = launcher_.start(b);
  slurm_.move_all("RUNNING");
  EXPECT_TRUE(launcher_.collect().empty());
  std::ofstream(a.run_directory / "job.end") << "1 85\n";
  const auto ended = launcher_.collect();
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_EQ(ended[0].case_id, "a");
  EXPECT_EQ(ended[0].exit_code, 85);
  EXPECT_EQ(launcher_.presence(b.run_directory, of_b), Presence::kRunning);
  launcher_.stop(b.run_directory, of_b, StopLevel::kTerminate);
  EXPECT_TRUE(slurm_.calls("scancel").empty()) << "that would end the other as well";
  EXPECT_EQ(text_of(b.run_directory / "job.stop"), "TERM\n");
  slurm_.move_all("CANCELLED");
  const auto last = launcher_.collect();
  ASSERT_EQ(last.size(), 1U);
  ASSERT_TRUE(last[0].verdict);
  EXPECT_EQ(last[0].verdict->outcome, AttemptOutcome::kKilled);
  EXPECT_TRUE(launcher_.idle());
  for (const auto& directory : {a.run_directory, b.run_directory})
    EXPECT_TRUE(std::filesystem::is_empty(directory)) << "nothing is left over";
}

TEST_F(PackedLauncher, CasesThatEndOneAfterTheOtherGoOnTogether) {
  LaunchRequest a = request("a"), b = request("b");
  static_cast<void>(launcher_.start(a));
  static_cast<void>(launcher_.start(b));
  slurm_.move_all("RUNNING");
  for (LaunchRequest* one : {&a, &b}) {
    std::ofstream(one->run_directory / "job.end") << "1 85\n";
    EXPECT_EQ(launcher_.collect().size(), 1U);
    one->attempt = 2;
    static_cast<void>(launcher_.start(*one));
  }
  const auto calls = slurm_.calls("sbatch");
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_NE(calls[1].find("2-cases"), std::string::npos) << calls[1];
}

TEST_F(PackedLauncher, AJobWhoseAcceptanceWasNotHeardIsFoundAsAWhole) {
  slurm_.play("sbatch", test::FakeSlurm::kAccept + "kill -9 $$");
  static_cast<void>(launcher_.start(request("a")));
  static_cast<void>(launcher_.start(request("b")));
  EXPECT_TRUE(launcher_.collect().empty());
  slurm_.move_all("COMPLETED");
  EXPECT_EQ(launcher_.collect().size(), 2U);
  EXPECT_EQ(slurm_.calls("sbatch").size(), 1U);
}

TEST_F(PackedLauncher, SharesNoMoreThanANodeHolds) {
  slurm_.play("sinfo", "echo 'main|10|3|'");
  launcher_.prepare("/opt/softwall-dns", 2);
  const std::size_t before = slurm_.calls("sbatch").size();
  for (const char* name : {"a", "b"}) static_cast<void>(launcher_.start(request(name)));
  std::this_thread::sleep_for(600ms);
  EXPECT_TRUE(launcher_.collect().empty());
  const auto calls = slurm_.calls("sbatch");
  ASSERT_EQ(calls.size(), before + 2);
  EXPECT_NE(calls.back().find("--ntasks=2"), std::string::npos) << calls.back();
}

TEST_F(PackedLauncher, DoesNotWaitForCompanyThatCannotCome) {
  static_cast<void>(launcher_.start(request("a")));
  EXPECT_TRUE(launcher_.collect().empty());
  EXPECT_EQ(slurm_.calls("sbatch").size(), 1U);
}

TEST_F(PackedLauncher, CasesThatWereNeverSubmittedAreGone) {
  const Handle handle = launcher_.start(request("a"));
  EXPECT_TRUE(slurm_.calls("sbatch").empty());
  SlurmLauncher next(options(), test::kQuickPace);
  EXPECT_EQ(next.presence(request("a").run_directory, handle), Presence::kGone);
}

}  // namespace
}  // namespace softwall::campaign
