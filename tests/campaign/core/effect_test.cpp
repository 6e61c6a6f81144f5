#include "campaign/core/effect.hpp"

#include <gtest/gtest.h>

#include "solver/case/case_schema.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

json filled(int interval_steps, double end_time, double fixed_dt, double block_length = 0.05) {
  json document = {{"physics",
                    {{"statistics", {{"interval_steps", interval_steps}, {"block_length", block_length}}},
                     {"time_step", {{"fixed_dt", fixed_dt}}}}},
                   {"run", {{"end_time", end_time}}}};
  if (fixed_dt == 0) document["physics"].erase("time_step");
  case_schema().fill_defaults(document);
  return document;
}

TEST(NeverSampled, IsWhatStartsAtItsEnd) {
  EXPECT_FALSE(never_sampled(filled(10, 1, 0), 0.5));
  EXPECT_TRUE(never_sampled(filled(10, 1, 0), 1));
  EXPECT_TRUE(never_sampled(filled(10, 1, 0), 2));
}

TEST(NeverSampled, IsAWindowInWhichNoBlockBegins) {
  EXPECT_FALSE(never_sampled(filled(10, 1, 0, 0.3), 0.9));  // the fourth begins there
  EXPECT_TRUE(never_sampled(filled(10, 1, 0, 0.3), 0.91));
  EXPECT_TRUE(never_sampled(filled(10, 1, 0, 1), 0.5));
  EXPECT_FALSE(never_sampled(filled(10, 1, 0, 1), 0));
  json earlier = filled(10, 1, 0, 1);
  earlier["physics"]["statistics"]["start_time"] = 0.5;  // where an earlier version began its blocks
  EXPECT_FALSE(never_sampled(earlier, 0.5));
  EXPECT_FALSE(never_sampled(earlier, 0.2));
}

TEST(NeverSampled, IsWhatEndsBeforeItsFirstSample) {
  EXPECT_TRUE(never_sampled(filled(11, 1, 0.1), 0));   // ten steps
  EXPECT_FALSE(never_sampled(filled(10, 1, 0.1), 0));  // sampled at the last
  EXPECT_TRUE(never_sampled(filled(3, 1, 0.1), 0.9));  // sampled at 0.3, 0.6 and 0.9
  EXPECT_FALSE(never_sampled(filled(3, 1, 0.1), 0.85));
}

TEST(Exclusions, ApplyToValuesThatTheSweepDoesNotSet) {
  const json physics = {{"solid", {{"G", 1}}}, {"reynolds", 2800}};
  ExclusionUse used(json::parse(R"([{"G": 2}, {"G": 1.0, "reynolds": 2800}])"));
  EXPECT_TRUE(used.excludes(physics));
  ASSERT_EQ(used.unused().size(), 1U);
  EXPECT_EQ(used.unused()[0].where, "/sweep/exclude/0/G");
  ExclusionUse other(json::parse(R"([{"G": 1, "reynolds": 3000}, {"fixed_dt": 1}])"));
  EXPECT_FALSE(other.excludes(physics));
  EXPECT_EQ(other.unused().size(), 2U);
  EXPECT_FALSE(ExclusionUse(json::array()).excludes(physics));
}

}  // namespace
}  // namespace softwall::campaign
