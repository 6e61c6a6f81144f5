#include "solver/solid/interface_share.hpp"

#include <gtest/gtest.h>

#include "tests/support/domain.hpp"

namespace softwall::solid {
namespace {

/// Whatever a is, both sides of the interface are counted whole: (1 - s) + s = 1, with 1 - s = (1 - phi)
/// times the fluid's factor.
TEST(InterfaceShare, CountsTheStressOnce) {
  for (const Real a : {0.0, 0.2, 0.5}) {
    for (const Real phi : {0.0, 0.1, 0.3, 0.5, 0.8, 0.99}) {
      EXPECT_NEAR((1 - phi) * factor_of_fluid(phi, a) + share_of_solid(phi, a), 1, 1e-12) << a << " " << phi;
    }
    EXPECT_EQ(share_of_solid(0, a), 0);
    EXPECT_EQ(share_of_solid(1, a), 1);
  }
}

TEST(InterfaceShare, IsTheMeanByVolumeWhereTheInterfaceIsSteep) {
  const support::Domain d(MPI_COMM_WORLD, {5, 6, 4}, {}, support::faces(6));
  InterfaceShare share(kFluidAtFlatInterface, d.grid);
  EXPECT_EQ(share.view().xy(2, 1), Real(0.5));
  share.follow([](int i, int) { return i < 3 ? 1.0 : 0.0; });
  EXPECT_EQ(share.view().xy(2, 1), Real(0.5));
  EXPECT_EQ(share.view().xy(3, 1), Real(0.25));  // between a flat column and a steep one
  EXPECT_EQ(share.view().xy(5, 1), Real(0));
  EXPECT_EQ(share.view().yz(3, 1), Real(0));
  EXPECT_EQ(share_of_solid(Real(0.3), share.view().yz(3, 1)), Real(0.3));
  EXPECT_EQ(share.largest_factor(), 2);
  EXPECT_FALSE(share.is_mean_by_volume());
  EXPECT_TRUE(InterfaceShare(kMeanByVolume, d.grid).is_mean_by_volume());
}

}  // namespace
}  // namespace softwall::solid
