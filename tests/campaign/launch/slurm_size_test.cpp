#include "campaign/launch/slurm_size.hpp"

#include <gtest/gtest.h>

#include "tests/campaign/launch/fake_slurm.hpp"

namespace softwall::campaign {
namespace {

TEST(ClusterSize, IsThatOfTheLargestPartition) {
  const auto size = parse_sinfo("small|4|16|\nlong|10|64|\nlong|2|128|\n");
  ASSERT_TRUE(size);
  EXPECT_EQ(size->nodes, 12);
  EXPECT_EQ(size->cores, 10 * 64 + 2 * 128);
  EXPECT_EQ(size->cores_of_a_node, 128);
}

TEST(ClusterSize, HalfAnAnswerIsNone) {
  for (const char* text : {"", "main|1|4", "main|1|4|", "main|one|4|\n", "main|1|4+|\n", "|1|4|\n",
                           "main|1|4|5|\n", "slurm_load_partitions: Unable to contact slurm controller\n"})
    EXPECT_FALSE(parse_sinfo(text)) << text;
}

TEST(ClusterSize, WhatCanNeverRunIsTold) {
  const test::FakeSlurm slurm;
  slurm.play("sinfo", "echo 'main|2|8|'");
  SlurmOptions options;
  options.partition = "main";
  const auto size = cluster_size(options, 5);
  ASSERT_TRUE(size);
  EXPECT_EQ(why_too_large(16, options, *size), "");
  EXPECT_EQ(why_too_large(17, options, *size), "its partitions have at most 16 cores");
  options.nodes = 3;
  EXPECT_EQ(why_too_large(1, options, *size), "its partitions have at most 2 nodes");
  options.nodes = 1;
  EXPECT_EQ(why_too_large(9, options, *size), "its nodes have at most 8 cores");
  EXPECT_NE(slurm.calls("sinfo").front().find("--partition=main"), std::string::npos);
  slurm.play("sinfo", "exit 1");
  EXPECT_FALSE(cluster_size(options, 5)) << "what is not known is no refusal";
}

}  // namespace
}  // namespace softwall::campaign
