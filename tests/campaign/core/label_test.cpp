#include "campaign/core/label.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace softwall::campaign {
namespace {

TEST(Label, ShowsTheParameters) {
  EXPECT_EQ(label_of({{"G", 0.5}, {"viscosity_ratio", 10}}), "G=0.5_mu=10");
  EXPECT_EQ(label_of({{"G", 1.0}, {"weno", "js"}}), "G=1_weno=js");
  EXPECT_EQ(label_of({{"min_eigenvalue", 1e-7}}), "min_eigenvalue=1e-07");
}

TEST(Label, IsSafeAsAFileName) {
  const std::string hostile = "a b/c\n$(x)`;'\"*?~\\|<>\033%:&";
  EXPECT_EQ(safe_label(hostile), "a-b-c---x-" + std::string(hostile.size() - 10, '-'));
  EXPECT_EQ(safe_label(""), "x");
  EXPECT_EQ(safe_label(".."), "x..");
  EXPECT_EQ(safe_label("../../etc"), "x..-..-etc");
  EXPECT_EQ(safe_label("-rf"), "x-rf");
  EXPECT_EQ(safe_label("\xC3\xA4"), "x--");
  EXPECT_EQ(safe_label(std::string(500, 'a')).size(), 80U);
  EXPECT_EQ(safe_label(std::string(500, '-')).size(), 80U);
  EXPECT_EQ(safe_label("G=1_mu=0.1"), "G=1_mu=0.1");
}

TEST(Label, DirectoriesAreToldApartByTheId) {
  EXPECT_EQ(case_directory("G=1", "0123456789abcdef"), "cases/G=1-01234567");
}

}  // namespace
}  // namespace softwall::campaign
