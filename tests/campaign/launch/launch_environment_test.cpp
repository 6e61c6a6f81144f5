#include "campaign/launch/launch_environment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

using ::testing::Contains;
using ::testing::Not;
using ::testing::StartsWith;

std::vector<std::string> given(const std::vector<std::string>& inherited) {
  return launch_environment(inherited, "/no/such", Scratch("/no/such"));
}

TEST(LaunchEnvironment, ALocalAttemptKnowsNothingOfAllocationsAndOtherMpiruns) {
  for (const char* name :
       {"SLURM_JOB_ID=7", "SLURM_NODELIST=here", "SLURM_TASKS_PER_NODE=1", "PBS_NODEFILE=/x", "LSB_HOSTS=a",
        "PE_HOSTFILE=/x", "PMI_RANK=0", "PMI2_FD=4", "PMIX_NAMESPACE=1", "OMPI_COMM_WORLD_RANK=0",
        "OMPI_MCA_orte_default_hostfile=/x", "OMPI_MCA_ess_base_jobid=1", "OMPI_MCA_pmix=^s1",
        "OMPI_MCA_mpi_oversubscribe=0", "SOFTWALL_SESSION=1"}) {
    EXPECT_THAT(given({name, "LANG=C"}), Not(Contains(name)));
    EXPECT_THAT(given({name, "LANG=C"}), Contains("LANG=C"));
  }
}

TEST(LaunchEnvironment, WhatAPersonChoseStays) {
  for (const char* name : {"OMPI_MCA_btl=self,tcp", "OMPI_MCA_mpi_yield_when_idle=0", "SLURMY=1", "HOME=/h"})
    EXPECT_THAT(given({name}), Contains(name));
}

TEST(LaunchEnvironment, WhatMpirunNeedsIsThereOnce) {
  EXPECT_THAT(given({}), Contains(StartsWith("HOME=/")));
  EXPECT_THAT(given({"HOME="}), Contains(StartsWith("HOME=/")));
  EXPECT_THAT(given({}), Contains("PATH=/usr/local/bin:/usr/bin:/bin"));
  EXPECT_THAT(given({"TMPDIR=relative"}), Not(Contains("TMPDIR=relative")));
  EXPECT_THAT(given({"PATH=/opt/bin"}), Contains("PATH=/opt/bin"));
}

TEST(SchedulerEnvironment, IsThatOfThePersonAndNotOfAJobThatWeAreIn) {
  EXPECT_EQ(scheduler_environment({"SLURM_CONF=/etc/slurm.conf", "SLURM_JOB_ID=12", "SLURM_NTASKS=1",
                                   "SQUEUE_STATES=R", "SBATCH_ACCOUNT=flow", "OMPI_MCA_btl=self",
                                   "PMIX_RANK=0", "PATH=/bin"}),
            (std::vector<std::string>{"SLURM_CONF=/etc/slurm.conf", "SBATCH_ACCOUNT=flow",
                                      "OMPI_MCA_btl=self", "PATH=/bin"}));
}

TEST(ScratchNames, ARelativeTemporaryFolderIsNotUsed) {
  setenv("TMPDIR", ".", 1);
  EXPECT_TRUE(Scratch("/no/such").session().is_absolute());
  unsetenv("TMPDIR");
}

TEST(ScratchNames, ANameThatAnotherHasTakenIsLeftToHim) {
  const test::TemporaryFolder temporary;
  setenv("TMPDIR", temporary.path().c_str(), 1);
  const auto first = Scratch("/no/such").session();
  std::filesystem::create_symlink("/etc", first);  // not a directory of ours
  const Scratch scratch("/no/such");
  EXPECT_NE(scratch.session(), first);
  scratch.create();
  EXPECT_EQ(Scratch("/no/such").session(), scratch.session());
  scratch.remove();
  EXPECT_TRUE(std::filesystem::is_symlink(first));
  unsetenv("TMPDIR");
}

}  // namespace
}  // namespace softwall::campaign
