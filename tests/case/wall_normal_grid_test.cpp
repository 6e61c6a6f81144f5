#include "solver/case/wall_normal_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwall {
namespace {

GridSpec grid(int ny_fluid, int ny_solid, double stretching) {
  return {4, ny_fluid, ny_solid, 4, stretching};
}

TEST(WallNormalGrid, EndsAreExactAndFacesIncrease) {
  for (const int ny_fluid : {4, 7, 64, 501})
    for (const int ny_solid : {0, 4, 9, 130})
      for (const double stretching : {0.0, 0.1, 1.7, 4.0})
        for (const double height : {0.5, 0.3, 2.0}) {
          const bool smooth = interface_spacing_problem(grid(ny_fluid, ny_solid, stretching), height).empty();
          if (ny_solid > 0 && stretching > 0.0 && !smooth) continue;
          const auto faces = wall_normal_faces(grid(ny_fluid, ny_solid, stretching), height);
          ASSERT_EQ(faces.size(), static_cast<std::size_t>(ny_fluid + ny_solid + 1));
          EXPECT_EQ(faces.front(), 0.0);
          EXPECT_EQ(faces[static_cast<std::size_t>(ny_fluid)], 2.0);
          EXPECT_EQ(faces.back(), ny_solid == 0 ? 2.0 : 2.0 + height);
          for (std::size_t j = 1; j < faces.size(); ++j) ASSERT_GT(faces[j], faces[j - 1]) << j;
        }
}

TEST(WallNormalGrid, FluidIsSymmetricAndFollowsItsFormula) {
  const int n = 40;
  const double s = 1.9;
  const auto faces = wall_normal_faces(grid(n, 0, s), 0.5);
  for (int j = 0; j <= n; ++j) {
    const auto at = static_cast<std::size_t>(j);
    EXPECT_NEAR(faces[at], 1.0 + std::tanh(s * (2.0 * j / n - 1.0)) / std::tanh(s), 1e-15);
    EXPECT_NEAR(faces[at] + faces[static_cast<std::size_t>(n - j)], 2.0, 1e-15);
  }
  EXPECT_LT(faces[1] - faces[0], faces[n / 2] - faces[n / 2 - 1]);
}

TEST(WallNormalGrid, LayerGrowsByOneFactorFromTheLastFluidCell) {
  const auto faces = wall_normal_faces(grid(64, 20, 1.5), 0.5);
  const double growth = (faces[65] - faces[64]) / (faces[64] - faces[63]);
  EXPECT_NEAR(growth, layer_growth(faces[64] - faces[63], 0.5, 20), 1e-12);
  for (std::size_t j = 65; j < 84; ++j)
    EXPECT_NEAR((faces[j + 1] - faces[j]) / (faces[j] - faces[j - 1]), growth, 1e-9);
}

TEST(WallNormalGrid, GrowthSumsToTheHeight) {
  for (const double spacing : {1e-3, 0.02, 0.125})
    for (const int cells : {4, 5, 33, 1000}) {
      const double r = layer_growth(spacing, 0.5, cells);
      double sum = 0.0, next = spacing;
      for (int k = 0; k < cells; ++k) sum += next *= r;
      EXPECT_NEAR(sum, 0.5, 1e-10) << spacing << " " << cells << " " << r;
    }
  EXPECT_NEAR(layer_growth(0.125, 0.5, 4), 1.0, 1e-9);
}

TEST(WallNormalGrid, UniformGridHasOneSpacing) {
  const auto faces = wall_normal_faces(grid(80, 20, 0.0), 0.5);
  for (std::size_t j = 1; j < faces.size(); ++j) EXPECT_NEAR(faces[j] - faces[j - 1], 0.025, 1e-15);
}

}  // namespace
}  // namespace softwall
