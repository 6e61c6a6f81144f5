#include "solver/solid/row_stiffness.hpp"

#include <gtest/gtest.h>

#include "solver/case/step_limits.hpp"
#include "solver/solid/fraction.hpp"
#include "solver/solid/transported_b/transported_b.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"
#include "tests/support/round_off.hpp"

namespace softwall::solid {
namespace {

constexpr int kFirstRow = 3;
constexpr double kG = 2, kDt = 0.4, kViscous = 0.05, kDriving = 0.3;

/// A layer whose lower rows are partly filled: phi rises from 0 to 1 with y, differently in each column.
Material material(const support::Domain& d) {
  const auto& g = d.grid;
  Material m(g);
  grid::for_each_cell({-1, g.nx + 1, kFirstRow - 1, g.ny + 1, -1, g.nz + 1}, [&](int i, int j, int k) {
    const double rise = 0.35 * (j - kFirstRow) - 0.5 + 0.1 * support::noise(1, (i + 12) % 12, 0, (k + 7) % 7);
    m.phi(i, j, k) = Real(std::clamp(rise, 0.0, 1.0));
    m.B.yy(i, j, k) = Real(1.5 + support::noise(2, (i + 12) % 12, j, (k + 7) % 7));
  });
  return m;
}

/// Residual of the system of one component, largest in all columns: what RowStiffness says it solves, written
/// down straight. flux(i, j, k): below the unknown of row j; height(j): around it.
template <class Change, class Flux, class Height>
double residual(const grid::Grid& g, int row0, const Change& before, const Change& q, double constant,
                const Flux& flux, const Height& height) {
  double worst = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int j = row0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        const double force = (flux(i, j + 1, k) - flux(i, j, k)) / height(j);
        worst = std::max(worst, std::abs(q(i, j, k) - force - before(i, j, k) - constant));
      }
    }
  }
  return worst;
}

class RowStiffnessOf : public testing::TestWithParam<double> {};

TEST_P(RowStiffnessOf, SolvesItsSystem) {
  const double ratio = GetParam();
  support::Domain d(MPI_COMM_SELF, {12, 14, 7}, {}, support::faces(14, 2, 1.2));
  const auto& g = d.grid;
  SolidSpec spec = support::solid_of(kG);
  spec.viscosity_ratio = ratio;
  const TransportedB formulation(spec, g, d.decomposition, d.halo);
  const Material m = material(d);
  const auto before = support::random_velocity(d, 5), predicted = support::random_velocity(d, 6);
  auto velocity = support::random_velocity(d, 6);
  RowStiffness(spec, formulation, g).apply(m, before, {kDt, kViscous, kDriving}, kFirstRow, velocity);

  const Fraction phi = fraction_of(m, formulation.interface_share(), g);
  const double elastic = (1 + step_limits::kSpareStiffness) * kG * kDt * kDt / 4;
  const double excess = ratio > 1 ? kViscous * (ratio - 1) : 0;
  const auto check = [&](grid::Field grid::VectorField::*component, double constant, const auto& share,
                         const auto& stretch) {
    const auto change = [&](const grid::VectorField& to) {
      return [&, component](int i, int j, int k) -> double {
        return (to.*component)(i, j, k) - (before.*component)(i, j, k);
      };
    };
    const auto q_inside = change(velocity);
    const auto q = [&](int i, int j, int k) { return j < g.ny ? q_inside(i, j, k) + constant : 0; };
    const auto slope = [&](int i, int j, int k) {
      const double below = j == g.ny ? -q(i, j - 1, k) : q(i, j, k);  // mirrored on the wall
      return (below - q(i, j - 1, k)) / g.dy_face[j];
    };
    const auto flux = [&](int i, int j, int k) {
      if (j == kFirstRow) return 0.0;
      const double part = j == g.ny ? 1 : share(i, j, k);
      const int of_solid = part < 0.9 ? j + 1 : j;
      return elastic * part * stretch(i, j, k) * slope(i, j, k) + excess * part * slope(i, of_solid, k);
    };
    using Change = std::function<double(int, int, int)>;
    EXPECT_LT(
        residual<Change>(g, kFirstRow, change(predicted), q, constant, flux, [&](int j) { return g.dy[j]; }),
        support::round_off(1000));
    for (int j = 0; j < kFirstRow; ++j)
      EXPECT_EQ((velocity.*component)(1, j, 2), (predicted.*component)(1, j, 2));
  };
  const auto between = [&](int j, const auto& a) {
    return j == g.ny ? a(j - 1) : g.upper_share[j] * a(j) + (1 - g.upper_share[j]) * a(j - 1);
  };
  check(
      &grid::VectorField::x, kDriving, [&](int i, int j, int k) { return phi.edge_xy(i, j, k); },
      [&](int i, int j, int k) {
        return between(j, [&](int row) { return (m.B.yy(i, row, k) + m.B.yy(i - 1, row, k)) / 2.0; });
      });
  check(
      &grid::VectorField::z, 0, [&](int i, int j, int k) { return phi.edge_yz(i, j, k); },
      [&](int i, int j, int k) {
        return between(j, [&](int row) { return (m.B.yy(i, row, k) + m.B.yy(i, row, k - 1)) / 2.0; });
      });
  const auto v = [&](int i, int j, int k) {
    return j < g.ny ? double(velocity.y(i, j, k)) - before.y(i, j, k) : 0.0;
  };
  using Change = std::function<double(int, int, int)>;
  const Change old = [&](int i, int j, int k) { return double(predicted.y(i, j, k)) - before.y(i, j, k); };
  const auto stress = [&](int i, int face, int k) {  // in the center below the face
    const int j = face - 1;
    if (face == kFirstRow) return 0.0;
    return (elastic * m.B.yy(i, j, k) + 2 * excess) * m.phi(i, j, k) * (v(i, face, k) - v(i, j, k)) / g.dy[j];
  };
  EXPECT_LT(residual<Change>(g, kFirstRow, old, v, 0, stress, [&](int j) { return g.dy_face[j]; }),
            support::round_off(1000));
}

INSTANTIATE_TEST_SUITE_P(Ratios, RowStiffnessOf, testing::Values(0.1, 1.0, 10.0));

}  // namespace
}  // namespace softwall::solid
