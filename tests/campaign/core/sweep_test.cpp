#include "campaign/core/sweep.hpp"

#include <gtest/gtest.h>

#include "campaign/core/parameters.hpp"
#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

json sweep(const char* text) {
  json document = json::parse(R"({"grid": {}, "zip": {}, "list": [], "exclude": []})");
  document.update(json::parse(text));
  return document;
}

/// All mistakes, one per line.
std::string mistakes(const char* text) {
  std::string found;
  for (const auto& mistake : sweep_mistakes(sweep(text)))
    found += mistake.where + ": " + mistake.given + "; " + mistake.allowed + "\n";
  return found;
}

/// "G nu" of each point: "1 0.1, 1 1, ..."
std::string points(const char* text) {
  std::string found;
  for (const auto& point : sweep_points(sweep(text))) {
    found += found.empty() ? "" : ", ";
    for (const auto& [pointer, value] : point)
      found += pointer.substr(pointer.rfind('/') + 1, 1) + value.dump() + " ";
    if (!point.empty()) found.pop_back();
  }
  return found;
}

TEST(Sweep, GridZipAndListInTheOrderWritten) {
  EXPECT_EQ(points(R"({"grid": {"G": [2, 1], "viscosity_ratio": [10, 1]}})"), "G2 v10, G2 v1, G1 v10, G1 v1");
  EXPECT_EQ(points(R"({"zip": {"G": [2, 1], "viscosity_ratio": [10, 1]}})"), "G2 v10, G1 v1");
  EXPECT_EQ(points(R"({"list": [{"G": 3}, {"viscosity_ratio": 5, "G": 4}]})"), "G3, G4 v5");
  EXPECT_EQ(points(R"({"list": [{"G": 3}], "grid": {"G": [1]}, "zip": {"G": [2]}})"), "G1, G2, G3");
}

TEST(Sweep, NothingNamedIsOnePoint) { EXPECT_EQ(sweep_points(sweep("{}")), std::vector<Point>{Point{}}); }

TEST(Sweep, ParametersHaveTwoNames) {
  EXPECT_EQ(sweep_points(sweep(R"({"list": [{"solid.G": 3}]})")),
            sweep_points(sweep(R"({"list": [{"G": 3}]})")));
  EXPECT_EQ(mistakes(R"({"grid": {"G": [1], "solid.G": [2]}})"),
            "/sweep/grid/solid.G: the same parameter under two names; name it once\n");
}

TEST(Sweep, EveryNameIsUniqueAndFindsItself) {
  for (const auto& parameter : parameters()) {
    EXPECT_EQ(find_parameter(parameter.name)->pointer, parameter.pointer) << parameter.name;
    EXPECT_EQ(find_parameter(parameter.full_name)->pointer, parameter.pointer) << parameter.full_name;
  }
  EXPECT_EQ(find_parameter("precursor"), nullptr);
  EXPECT_EQ(find_parameter("flow"), nullptr);
  EXPECT_EQ(find_parameter("grid"), nullptr);
}

TEST(Sweep, UnknownParametersAreNamedWithASuggestion) {
  EXPECT_EQ(
      mistakes(
          R"({"grid": {"viscosity_rato": [1]}, "list": [{"G": 1}, {"g0": 2}], "exclude": [{"reynold": 1}]})"),
      "/sweep/grid/viscosity_rato: no such parameter; did you mean \"viscosity_ratio\"?\n"
      "/sweep/list/1/g0: no such parameter; did you mean \"G\"?\n"
      "/sweep/exclude/0/reynold: no such parameter; did you mean \"reynolds\"?\n");
}

TEST(Sweep, ZippedListsHaveOneLength) {
  EXPECT_EQ(mistakes(R"({"zip": {"G": [1, 2], "nx": [8]}})"),
            "/sweep/zip: lists of unequal length; G has 2, nx has 1\n");
}

TEST(Sweep, ExplosionsAreRefusedBeforeTheyHappen) {
  EXPECT_NE(mistakes(R"({"grid": {
      "G": [1,2,3,4,5,6,7,8,9,10], "viscosity_ratio": [1,2,3,4,5,6,7,8,9,10], "nx": [1,2,3,4,5,6,7,8,9,10],
      "nz": [1,2,3,4,5,6,7,8,9,10], "ny_fluid": [1,2,3,4,5,6,7,8,9,10], "ny_solid": [1,2,3,4,5,6,7,8,9,10],
      "reynolds": [1,2,3,4,5,6,7,8,9,10], "threshold": [1,2,3,4,5,6,7,8,9,10], "seed": [1,2,3,4,5,6,7,8,9,10],
      "safety": [1,2,3,4,5,6,7,8,9,10], "length_x": [1,2,3,4,5,6,7,8,9,10], "length_z": [1,2,3,4,5,6,7,8,9,10],
      "amplitude": [1,2,3,4,5,6,7,8,9,10], "fixed_dt": [1,2,3,4,5,6,7,8,9,10], "stretching": [1,2,3,4,5,6,7,8,9,10],
      "start_time": [1,2,3,4,5,6,7,8,9,10], "block_length": [1,2,3,4,5,6,7,8,9,10], "interval_steps": [1,2,3,4,5,6,7,8,9,10],
      "layer_height": [1,2,3,4,5,6,7,8,9,10], "min_eigenvalue": [1,2,3,4,5,6,7,8,9,10]}})")
                .find("too many cases"),
            std::string::npos);
  json wide = sweep("{}");
  for (int i = 0; i < 100; ++i) {
    wide["grid"]["G"].push_back(1 + i);
    wide["grid"]["viscosity_ratio"].push_back(1 + i);
  }
  EXPECT_TRUE(sweep_mistakes(wide).empty());  // exactly the limit
  wide["list"].push_back({{"G", 500}});
  EXPECT_EQ(sweep_mistakes(wide).size(), 1U);
}

}  // namespace
}  // namespace softwall::campaign
