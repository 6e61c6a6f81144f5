#include <gtest/gtest.h>

#include <functional>

#include "solver/case/cofactor_stiffness.hpp"
#include "solver/solid/cofactors.hpp"
#include "solver/solid/elastic_force.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/fields.hpp"

// The second constant of the elastic law: cofactors of B where its components live, and the force of a stress
// that has them, against formulas.
namespace softwall::solid {
namespace {

using support::Domain;

struct Tensor {
  double xx, yy, zz, xy, xz, yz;
};

Tensor cofactors(const Tensor& b) {
  return {b.yy * b.zz - b.yz * b.yz, b.xx * b.zz - b.xz * b.xz, b.xx * b.yy - b.xy * b.xy,
          b.xz * b.yz - b.xy * b.zz, b.xy * b.yz - b.xz * b.yy, b.xy * b.xz - b.yz * b.xx};
}

/// A smooth field that no two components share, periodic in 3 and 1.5.
Tensor smooth(double x, double y, double z) {
  const double a = 2 * M_PI / 3 * x, c = 2 * M_PI / 1.5 * z;
  return {2 + 0.3 * std::sin(a + y), 1.5 + 0.3 * std::cos(a - c),   1.8 + 0.2 * std::sin(c + 2 * y),
          0.4 * std::cos(a + c + y), 0.3 * std::sin(a - 2 * y + c), 0.5 * std::cos(c - y) * std::cos(a)};
}

using Field = std::function<Tensor(double, double, double)>;

Material filled(Domain& d, const Field& value) {
  const auto& g = d.grid;
  Material m(g);
  const auto set = [&](grid::Field& field, const support::Place& place, double Tensor::*component) {
    support::set_by_position(field, g, place,
                             [&](double x, double y, double z) { return value(x, y, z).*component; });
    d.halo.fill({&field});
  };
  set(m.B.xx, support::kCenter, &Tensor::xx);
  set(m.B.yy, support::kCenter, &Tensor::yy);
  set(m.B.zz, support::kCenter, &Tensor::zz);
  set(m.B.xy, support::kEdgeXy, &Tensor::xy);
  set(m.B.xz, support::kEdgeXz, &Tensor::xz);
  set(m.B.yz, support::kEdgeYz, &Tensor::yz);
  support::set_by_index(m.phi, g, g.ny, [](int, int, int) { return 1; });
  d.halo.fill({&m.phi});
  return m;
}

TEST(Cofactors, OfAUniformTensorAreExactOffTheWalls) {
  Domain d(MPI_COMM_WORLD, {14, 6, 13}, {}, support::faces(6, 2, 1.4));
  const Tensor B{2, 1.5, 1.25, 0.5, -0.25, 0.75}, exact = cofactors(B);
  const Material m = filled(d, [&](double, double, double) { return B; });
  const Cofactors C = cofactors_of(m, d.grid);
  for (int j = 1; j < d.grid.ny; ++j) {
    for (int i = 0; i <= d.grid.nx; ++i) {
      EXPECT_NEAR(C.xx(i, j - 1, 0), exact.xx, 1e-14);
      EXPECT_NEAR(C.yy(i, j - 1, 0), exact.yy, 1e-14);
      EXPECT_NEAR(C.zz(i, j - 1, 0), exact.zz, 1e-14);
      EXPECT_NEAR(C.xy(i, j, 0), exact.xy, 1e-14);
      EXPECT_NEAR(C.xz(i, j - 1, 0), exact.xz, 1e-14);
      EXPECT_NEAR(C.xz_of_center(i, j - 1, 0), exact.xz, 1e-14);
      EXPECT_NEAR(C.yz(i, j, 0), exact.yz, 1e-14);
    }
  }
}

/// What clings to a wall is sheared along it, by a in x and b in z.
TEST(Cofactors, OnAWallAreThoseOfShearAlongIt) {
  Domain d(MPI_COMM_WORLD, {14, 6, 13}, {}, support::faces(6));
  const double a = 0.5, b = -0.75;
  const Tensor B{1 + a * a, 1, 1 + b * b, a, a * b, b}, exact = cofactors(B);
  const Material m = filled(d, [&](double, double, double) { return B; });
  const Cofactors C = cofactors_of(m, d.grid);
  for (const int wall : {0, d.grid.ny}) {
    EXPECT_NEAR(C.xy(0, wall, 0), exact.xy, 1e-14);
    EXPECT_NEAR(C.yz(0, wall, 0), exact.yz, 1e-14);
  }
}

/// d s_ij / dx_j of the formulas, by differences so small that they count for nothing.
std::array<double, 3> exact_force(const ElasticLaw<double>& law, double x, double y, double z) {
  const auto stress = [&](double a, double b, double c) {
    const Tensor B = smooth(a, b, c), C = cofactors(B);
    return Tensor{law.normal_stress(B.xx, C.xx), law.normal_stress(B.yy, C.yy), law.normal_stress(B.zz, C.zz),
                  law.shear_stress(B.xy, C.xy),  law.shear_stress(B.xz, C.xz),  law.shear_stress(B.yz, C.yz)};
  };
  constexpr double h = 1e-5;
  const Tensor x0 = stress(x - h, y, z), x1 = stress(x + h, y, z), y0 = stress(x, y - h, z),
               y1 = stress(x, y + h, z), z0 = stress(x, y, z - h), z1 = stress(x, y, z + h);
  return {(x1.xx - x0.xx + y1.xy - y0.xy + z1.xz - z0.xz) / (2 * h),
          (x1.xy - x0.xy + y1.yy - y0.yy + z1.yz - z0.yz) / (2 * h),
          (x1.xz - x0.xz + y1.yz - y0.yz + z1.zz - z0.zz) / (2 * h)};
}

/// Largest error of the force, in rows whose stress needs no wall.
double force_error(const ElasticLaw<Real>& law, int n) {
  Domain d(MPI_COMM_WORLD, {n, n, n}, {}, support::faces(n, 2, 1.2));
  const auto& g = d.grid;
  const InterfaceShare share(kMeanByVolume, g);
  const Material m = filled(d, smooth);
  ElasticForce force(law, share, g);
  for (int k = 0; k < g.nz; ++k) force.find(m, 0, k);
  double worst = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 2; j < g.ny - 1; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        const double x = (g.x_begin + i) * g.dx, z = (g.z_begin + k) * g.dz, y = g.y_center[j];
        const ElasticLaw<double> exact{law.G, law.mooney_share};
        const auto error = [&](const grid::Field& f, std::size_t component, double a, double b, double c) {
          worst = support::worse(worst, std::abs(f(i, j, k) - exact_force(exact, a, b, c)[component]));
        };
        error(force.now().x, 0, x, y, z + g.dz / 2);
        error(force.now().y, 1, x + g.dx / 2, g.y_face[j], z + g.dz / 2);
        error(force.now().z, 2, x + g.dx / 2, y, z);
      }
    }
  }
  return support::worst(d.decomposition.all(), worst);
}

TEST(MooneyRivlin, ForceIsSecondOrder) {
  for (const double share : {0.0, 0.4, 1.0}) {
    std::vector<double> errors;
    for (const int n : {16, 32, 64}) errors.push_back(force_error({Real(2.5), Real(share)}, n));
    support::expect_order("force of a Mooney-Rivlin solid, c2 / G " + std::to_string(share).substr(0, 3),
                          errors, 1.9);
  }
}

/// The bound of what is explicit against the stiffness itself, for waves in all directions.
TEST(MooneyRivlin, WhatStaysExplicitIsBoundedForWavesInAllDirections) {
  using step_limits::Deformation, step_limits::InverseSpacings;
  const InverseSpacings<double> inv{1, 4, 1.3};
  for (const double shear : {0.0, 0.5, 2.0}) {
    const Tensor B{1 + shear * shear, 1, 1 + 0.25 * shear * shear, shear, 0.5 * shear * shear, 0.5 * shear},
        C = cofactors(B);
    const Deformation<double> cells{C.xx, C.yy, C.zz, C.xy, C.xz, C.yz};
    const double whole = cofactor_stiffness(cells, inv), along = cofactor_stiffness_along_rows(cells, inv);
    double most = 0, most_explicit = -1e300;
    for (int n = 0; n < 20000; ++n) {
      // Any k within the grid's largest, and any a normal to it.
      const double kx = inv.dx * support::noise(1, n, 0, 0), ky = inv.dy * support::noise(2, n, 0, 0),
                   kz = inv.dz * support::noise(3, n, 0, 0);
      const double px = support::noise(4, n, 0, 0), py = support::noise(5, n, 0, 0),
                   pz = support::noise(6, n, 0, 0);
      double ax = ky * pz - kz * py, ay = kz * px - kx * pz, az = kx * py - ky * px;
      const double length = std::sqrt(ax * ax + ay * ay + az * az), k2 = kx * kx + ky * ky + kz * kz;
      if (length < 1e-6) continue;
      ax /= length, ay /= length, az /= length;
      const double all = k2 * (C.xx * ax * ax + C.yy * ay * ay + C.zz * az * az +
                               2 * (C.xy * ax * ay + C.xz * ax * az + C.yz * ay * az));
      const double implicit = ky * ky *
                              (step_limits::implicit_in_plane(C.xx, C.xz) * ax * ax +
                               step_limits::implicit_in_plane(C.zz, C.xz) * az * az +
                               step_limits::implicit_along_y(C.xx, C.zz) * ay * ay);
      most = std::max(most, all);
      most_explicit = std::max(most_explicit, all - (1 + step_limits::kSpareStiffness) * implicit);
    }
    EXPECT_LE(most, whole);
    EXPECT_LE(most_explicit, along);
    EXPECT_GT(most, 0.3 * whole) << "a bound that loose costs too much";
  }
}

}  // namespace
}  // namespace softwall::solid
