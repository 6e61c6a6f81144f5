#include "solver/case/spelling.hpp"

#include <gtest/gtest.h>

namespace softwall {
namespace {

TEST(Spelling, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("end_time", "end_time"), 0);
  EXPECT_EQ(edit_distance("end_tiem", "end_time"), 1);  // two neighbours swapped
  EXPECT_EQ(edit_distance("endtime", "end_time"), 1);
  EXPECT_EQ(edit_distance("REYNOLDS", "reynolds"), 0);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 3);
}

TEST(Spelling, SuggestsOnlyWhatIsNear) {
  const std::vector<std::string> known{"G", "nx", "nz", "stretching", "viscosity_ratio"};
  EXPECT_EQ(suggestion("strecthing", known), "stretching");
  EXPECT_EQ(suggestion("viscosity-ratio", known), "viscosity_ratio");
  EXPECT_EQ(suggestion("g", known), "G");
  EXPECT_EQ(suggestion("nxx", known), "nx");
  EXPECT_EQ(suggestion("temperature", known), std::nullopt);
  EXPECT_EQ(suggestion("", known), std::nullopt);
  EXPECT_EQ(suggestion("Q", known), std::nullopt);  // no letter in common
  EXPECT_EQ(suggestion(std::string(1000000, 'G'), known), std::nullopt);
}

}  // namespace
}  // namespace softwall
