#include "solver/solid/stress_divergence.hpp"

#include <gtest/gtest.h>

#include "tests/support/fields.hpp"
#include "tests/support/round_off.hpp"

// The sweep keeps stresses for the next row; it must find what their differences are at each place alone.
namespace softwall::solid {
namespace {

using support::Domain;

/// Another number at every place of every component.
template <bool kOnlyAcrossRows>
struct NoiseStress {
  static constexpr bool kAcrossRowsOnly = kOnlyAcrossRows;
  static Real of(int component, int i, int j, int k) { return Real(support::noise(component, i, j, k)); }
  static Real between_planes(int component, int i, int j, int k) {
    return kOnlyAcrossRows ? Real(0) : of(component, i, j, k);
  }
  Real xx(int i, int j, int k) const { return between_planes(1, i, j, k); }
  Real yy(int i, int j, int k) const { return between_planes(2, i, j, k); }
  Real zz(int i, int j, int k) const { return between_planes(3, i, j, k); }
  Real xz(int i, int j, int k) const { return between_planes(4, i, j, k); }
  Real xy(int i, int j, int k) const { return of(5, i, j, k); }
  Real yz(int i, int j, int k) const { return of(6, i, j, k); }
};

template <class Stress>
struct AtAPlace {
  Stress s;
  const grid::Grid& g;
  double force_x(int i, int j, int k) const {
    return (s.xx(i, j, k) - s.xx(i - 1, j, k)) / g.dx + (s.xy(i, j + 1, k) - s.xy(i, j, k)) * g.inv_dy[j] +
           (s.xz(i, j, k + 1) - s.xz(i, j, k)) / g.dz;
  }
  double force_y(int i, int j, int k) const {
    return (s.xy(i + 1, j, k) - s.xy(i, j, k)) / g.dx +
           (s.yy(i, j, k) - s.yy(i, j - 1, k)) * g.inv_dy_face[j] +
           (s.yz(i, j, k + 1) - s.yz(i, j, k)) / g.dz;
  }
  double force_z(int i, int j, int k) const {
    return (s.xz(i + 1, j, k) - s.xz(i, j, k)) / g.dx + (s.yz(i, j + 1, k) - s.yz(i, j, k)) * g.inv_dy[j] +
           (s.zz(i, j, k) - s.zz(i, j, k - 1)) / g.dz;
  }
};

template <class Stress>
void expect_the_differences(Domain& d, int j0, int j1) {
  const auto& g = d.grid;
  StressDivergence divergence(g);
  const AtAPlace<Stress> plain{{}, g};
  grid::VectorField force(g, 0);
  double worst = 0, largest = 0;
  for (int k = 0; k < g.nz; ++k) {
    divergence.find(Stress{}, j0, j1, k, force);
    for (int j = j0; j < j1; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        worst = support::worse(worst, std::abs(force.x(i, j, k) - plain.force_x(i, j, k)));
        worst = support::worse(worst, std::abs(force.z(i, j, k) - plain.force_z(i, j, k)));
        if (j > 0) worst = support::worse(worst, std::abs(force.y(i, j, k) - plain.force_y(i, j, k)));
        largest = support::worse(largest, std::abs(double(force.x(i, j, k))));
      }
    }
  }
  EXPECT_GT(largest, 1);
  EXPECT_LE(worst, support::round_off(100) * largest);
}

TEST(StressDivergence, FindsTheDifferencesAtEachPlace) {
  for (const Domain::Size& n : {Domain::Size{9, 12, 4}, {16, 7, 4}, {5, 6, 5}}) {
    Domain d(MPI_COMM_WORLD, n, {}, support::faces(n.ny, 2, 1.4));
    for (const int j0 : {0, 3}) {
      expect_the_differences<NoiseStress<false>>(d, j0, n.ny);
      expect_the_differences<NoiseStress<true>>(d, j0, n.ny - 1);
    }
  }
}

}  // namespace
}  // namespace softwall::solid
