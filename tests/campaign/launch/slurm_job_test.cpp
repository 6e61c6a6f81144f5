#include "campaign/launch/slurm_job.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

#include "campaign/core/spec.hpp"
#include "tests/campaign/core/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

SlurmOptions options(const nlohmann::json& given = nlohmann::json::object()) {
  auto document = tests::elastic_campaign();
  document["execution"] = {{"launcher", "slurm"}, {"slurm", given}};
  return tests::campaign_of(document).execution.slurm;
}

LaunchRequest request_in(const std::filesystem::path& run_directory, int attempt = 3) {
  return {"0123456789abcdef", run_directory, attempt, 4, std::nullopt};
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

TEST(SlurmJob, NameTellsCampaignCaseAndAttempt) {
  const std::string name = job_name(request_in("/data/walls/cases/G=0.5_mu=1-0123abcd"));
  EXPECT_TRUE(name.starts_with("softwall.walls.G=0.5_mu=1-0123abcd.3.")) << name;
}

TEST(SlurmJob, NameIsTheOnlyOneOfItsKind) {
  const std::string name = job_name(request_in("/data/walls/cases/a-0123abcd"));
  EXPECT_NE(name, job_name(request_in("/copy/walls/cases/a-0123abcd")));
  EXPECT_NE(name, job_name(request_in("/data/walls/cases/a-0123abcd", 4)));
}

TEST(SlurmJob, NameHasNoCharacterThatSlurmOrAShellTakesForMore) {
  const std::string name = job_name(request_in("/data/a, b;$(x)\n%j'/cases/" + std::string(300, 'x') + ",|"));
  EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._=+-"),
            std::string::npos)
      << name;
  EXPECT_LT(name.size(), 200U);
}

TEST(SlurmJob, HandleComesBackAndThoseOfOthersAreNotTakenForOurs) {
  const auto job = job_of(handle_of({"softwall.x", 2, "17", "/data/x"}));
  ASSERT_TRUE(job);
  EXPECT_EQ(job->directory, "/data/x");
  EXPECT_EQ(job_of(R"({"slurm":"softwall.x","attempt":2,"job":"17"})")->directory, "")
      << "of an earlier version";
  EXPECT_TRUE(job_of(handle_of({"softwall.x", 2, "17", "/data/\xff"}))) << "a name that is no UTF-8";
  EXPECT_EQ(job->name, "softwall.x");
  EXPECT_EQ(job->attempt, 2);
  EXPECT_EQ(job->number, "17");
  for (const char* other : {"", "job 1", "{}", "[1]", R"({"pid":1,"host":"x"})", R"({"slurm":1})"})
    EXPECT_FALSE(job_of(other)) << other;
}

TEST(SlurmJob, ScriptEndsInTheSolverUnderMpirunAndQuotesItsWords) {
  const test::TemporaryFolder folder;
  const auto run = folder.path() / "a $(touch pwned) 'b'";
  std::filesystem::create_directories(run);
  auto slurm = options({{"start_options", {"--bind-to", "none"}}});
  const std::string text =
      script_text(request_in(run), slurm, {"/opt/mpi run", "/opt/softwall-dns"}, "# job: a\n");
  EXPECT_NE(text.find("\nexec '/opt/mpi run' --bind-to none -n 4 /opt/softwall-dns "), std::string::npos)
      << text;
  EXPECT_TRUE(text.ends_with(" --attempt 3\n")) << text;
  EXPECT_EQ(text.find(" " + run.string()), std::string::npos) << "not quoted: " << text;
}

TEST(SlurmJob, AJobThatSlurmBeginsAgainEndsAtOnce) {
  const test::TemporaryFolder folder;
  const auto script =
      folder.write("job.sh", script_text(request_in(folder.path()), options(), {"/bin/echo", "begun"}, ""));
  const auto run = [&](const std::string& setting) {
    const std::string log = (folder.path() / "log").string();
    const int status = std::system((setting + " sh " + script.string() + " > " + log).c_str());
    return std::pair(WEXITSTATUS(status), std::filesystem::file_size(log) > 0);
  };
  EXPECT_EQ(run("SLURM_JOB_ID=1"), std::pair(0, true));
  EXPECT_EQ(run("SLURM_RESTART_COUNT=0"), std::pair(0, true));
  EXPECT_EQ(run("SLURM_RESTART_COUNT=1"), std::pair(85, true));
}

TEST(SlurmJob, ArgumentsAskForWhatTheCampaignAsksFor) {
  const auto plain = submit_arguments(request_in("/data/w/cases/a-0"), options(), "softwall.a");
  for (const char* word :
       {"--parsable", "--job-name=softwall.a", "--no-requeue", "--dependency=singleton", "--ntasks=4",
        "--open-mode=append", "--chdir=/data/w/cases/a-0", "--output=solver.log", "--signal=B:USR1@120"})
    EXPECT_TRUE(has(plain, word)) << word;
  for (const std::string& word : plain) {
    for (const char* name : {"--account", "--partition", "--time", "--nodes"})
      EXPECT_FALSE(word.starts_with(name));
  }
  const auto full = submit_arguments(request_in("/data/w/cases/a-0"),
                                     options({{"account", "flow"},
                                              {"partition", "long"},
                                              {"time_limit_minutes", 90},
                                              {"nodes", 2},
                                              {"signal_seconds", 300},
                                              {"start_with", "srun"},
                                              {"options", {"--constraint=a|b"}}}),
                                     "softwall.a");
  for (const char* word : {"--account=flow", "--partition=long", "--time=90", "--nodes=2",
                           "--signal=USR1@300", "--constraint=a|b"})
    EXPECT_TRUE(has(full, word)) << word;
}

TEST(SlurmJob, TheSolversClockEndsBeforeTheTimeLimit) {
  auto request = request_in("/data/w/cases/a-0");
  EXPECT_FALSE(solver_seconds(request, options()));
  EXPECT_EQ(solver_seconds(request, options({{"time_limit_minutes", 60}})), 3540.0);
  EXPECT_EQ(solver_seconds(request, options({{"time_limit_minutes", 1}, {"signal_seconds", 30}})), 54.0);
  request.wall_seconds = 100.0;
  EXPECT_EQ(solver_seconds(request, options({{"time_limit_minutes", 60}})), 100.0);
  EXPECT_EQ(solver_seconds(request, options()), 100.0);
}

TEST(SlurmJob, AsksForNoMoreTimeThanTheCaseIsKnownToNeed) {
  const auto slurm = options({{"time_limit_minutes", 600}, {"signal_seconds", 120}});
  auto request = request_in("/data/w/cases/a-0");
  EXPECT_EQ(time_limit(request, slurm), 600) << "nothing has been measured";
  request.needed_seconds = 3600;
  EXPECT_EQ(time_limit(request, slurm), 78) << "a quarter more, a minute to start, two after the signal";
  EXPECT_TRUE(has(submit_arguments(request, slurm, "softwall.a"), "--time=78"));
  EXPECT_EQ(solver_seconds(request, slurm), 78 * 60.0 - 60.0);
  request.needed_seconds = 1;
  EXPECT_EQ(time_limit(request, slurm), 10) << "never less";
  EXPECT_EQ(time_limit(request, options({{"time_limit_minutes", 5}})), 5);
  request.needed_seconds = 1e9;
  EXPECT_EQ(time_limit(request, slurm), 600) << "nor more than the campaign's";
  EXPECT_FALSE(time_limit(request, options())) << "the partition's limit is not known";
}

TEST(SlurmJob, AStopAsksMoreFirmlyFromLevelToLevel) {
  const auto ask = [&](StopLevel level) { return cancel_arguments("softwall.x", level, options()); };
  const auto checkpoint = ask(StopLevel::kCheckpoint);
  ASSERT_EQ(checkpoint.size(), 2U);
  EXPECT_TRUE(has(checkpoint[0], "--state=PENDING"));
  EXPECT_TRUE(has(checkpoint[1], "--signal=USR1"));
  EXPECT_TRUE(has(checkpoint[1], "--batch"));
  const auto terminate = ask(StopLevel::kTerminate);
  ASSERT_EQ(terminate.size(), 1U);
  EXPECT_EQ(terminate[0].size(), 2U) << "whose and which, nothing else";
  EXPECT_TRUE(has(ask(StopLevel::kKill)[0], "--signal=KILL"));
  for (const StopLevel level : {StopLevel::kCheckpoint, StopLevel::kTerminate, StopLevel::kKill}) {
    for (const auto& words : ask(level)) EXPECT_TRUE(has(words, "--name=softwall.x"));
  }
  const auto by_srun =
      cancel_arguments("softwall.x", StopLevel::kCheckpoint, options({{"start_with", "srun"}}));
  EXPECT_FALSE(has(by_srun[1], "--batch")) << "its ranks are steps";
}

}  // namespace
}  // namespace softwall::campaign
