#include "campaign/core/effect.hpp"

#include <gtest/gtest.h>

#include "solver/case/case_schema.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

json filled(double start_time, int interval_steps, double end_time, double fixed_dt) {
  json document = {{"physics",
                    {{"statistics", {{"start_time", start_time}, {"interval_steps", interval_steps}}},
                     {"time_step", {{"fixed_dt", fixed_dt}}}}},
                   {"run", {{"end_time", end_time}}}};
  if (fixed_dt == 0) document["physics"].erase("time_step");
  case_schema().fill_defaults(document);
  return document;
}

TEST(NeverSampled, IsWhatStartsAtItsEnd) {
  EXPECT_FALSE(never_sampled(filled(0.5, 10, 1, 0)));
  EXPECT_TRUE(never_sampled(filled(1, 10, 1, 0)));
  EXPECT_TRUE(never_sampled(filled(2, 10, 1, 0)));
}

TEST(NeverSampled, IsWhatEndsBeforeItsFirstSample) {
  EXPECT_TRUE(never_sampled(filled(0, 11, 1, 0.1)));   // ten steps
  EXPECT_FALSE(never_sampled(filled(0, 10, 1, 0.1)));  // sampled at the last
  EXPECT_TRUE(never_sampled(filled(0.9, 3, 1, 0.1)));  // sampled at 0.3, 0.6 and 0.9
  EXPECT_FALSE(never_sampled(filled(0.85, 3, 1, 0.1)));
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
