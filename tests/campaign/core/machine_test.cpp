#include "campaign/core/machine.hpp"

#include <gtest/gtest.h>

#include "tests/campaign/core/examples.hpp"
#include "tests/support/solid_spec.hpp"

namespace softwall::campaign {
namespace {

const Machine kSmall{2, 8e9, {{"single", "/bin/softwall-dns-single"}}};

/// One line for each obstacle of an elastic case of 48 x (64 + 16) x 48 cells.
std::vector<std::string> told(int ranks, const Execution& execution = {},
                              Precision precision = Precision::kDouble, int nx = 48) {
  CampaignCase one = tests::campaign_of(tests::elastic_campaign()).cases.back();
  one.ranks = ranks;
  one.definition.physics.precision = precision;
  one.definition.physics.grid.nx = nx;
  std::vector<std::string> lines;
  for (const Mistake& mistake : obstacles(one, execution, kSmall))
    lines.push_back(mistake.where + ": " + mistake.given + "; " + mistake.allowed);
  return lines;
}

TEST(Obstacles, AreNoneForWhatFits) { EXPECT_TRUE(told(2).empty()); }

TEST(Obstacles, MoreRanksThanCores) {
  ASSERT_EQ(told(3).size(), 1U);
  EXPECT_EQ(told(3)[0], "/execution/ranks: 3; this machine has 2 cores; execution.cores may say otherwise");
  Execution more;
  more.cores = 4;
  EXPECT_TRUE(told(3, more).empty());
}

TEST(Obstacles, MoreRanksThanTheGridCanFeed) {
  Execution many;
  many.cores = 1000;
  ASSERT_EQ(told(17, many).size(), 1U);  // a prime: all in one direction
  EXPECT_NE(told(17, many)[0].find("a grid of 48 x 48 columns cannot be shared among 17 ranks"),
            std::string::npos);
  EXPECT_TRUE(told(16, many).empty());
}

TEST(Obstacles, APrecisionWithoutItsProgram) {
  ASSERT_EQ(told(1, {}, Precision::kSingle).size(), 1U);
  EXPECT_EQ(told(1, {}, Precision::kSingle)[0].find("/physics/precision: single"), 0U);
  EXPECT_NE(told(1, {}, Precision::kSingle)[0].find("/bin/softwall-dns-single"), std::string::npos);
}

TEST(Obstacles, MoreMemoryThanThereIs) {
  ASSERT_EQ(told(1, {}, Precision::kDouble, 96000).size(), 1U);
  EXPECT_NE(told(1, {}, Precision::kDouble, 96000)[0].find("of memory; this machine has 8 GB"),
            std::string::npos);
}

/// As measured: the largest resident memory of runs on one rank, 64 x 64 x 64 cells, 16 more in the layer.
TEST(Memory, IsWhatWasMeasured) {
  Case c = tests::campaign_of(tests::elastic_campaign()).cases.front().definition;
  c.physics.grid = {64, 64, 0, 64, 0};
  EXPECT_NEAR(memory_bytes(c, 1), 79.2e6 * 1.048576, 5e6);
  c.physics.precision = Precision::kSingle;
  EXPECT_NEAR(memory_bytes(c, 1), 63.9e6 * 1.048576, 5e6);
  c.physics.solid = support::solid_of(1);
  c.physics.grid.ny_solid = 16;
  EXPECT_NEAR(memory_bytes(c, 1), 95.4e6 * 1.048576, 7e6);
  c.physics.precision = Precision::kDouble;
  EXPECT_NEAR(memory_bytes(c, 1), 136.1e6 * 1.048576, 8e6);
  c.physics.solid->formulation = SolidFormulation::kReferenceMap;
  EXPECT_NEAR(memory_bytes(c, 1), 127.3e6 * 1.048576, 8e6);
}

}  // namespace
}  // namespace softwall::campaign
