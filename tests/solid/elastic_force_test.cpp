#include "solver/solid/elastic_force.hpp"

#include <gtest/gtest.h>

#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"
#include "tests/support/round_off.hpp"

namespace softwall::solid {
namespace {

using support::Domain;
using support::noise;

constexpr int kAllSolidFrom = 4;

/// Noise for B; for phi, too, below the rows that are solid altogether.
Material half_solid(Domain& d) {
  const auto& g = d.grid;
  Material m(g);
  int seed = 0;
  for (grid::Field* f : {&m.B.xx, &m.B.yy, &m.B.zz, &m.B.xy, &m.B.xz, &m.B.yz}) {
    ++seed;
    support::set_by_index(*f, g, g.ny + 1, [=](int i, int j, int k) { return noise(seed, i, j, k); });
    d.halo.fill({f});
  }
  support::set_by_index(m.phi, g, g.ny + 1, [=](int i, int j, int k) {
    return j < kAllSolidFrom ? (1 + noise(7, i, j, k)) / 2 : 1.0;
  });
  d.halo.fill({&m.phi});
  return m;
}

/// Where all is known to be solid the fractions are not looked at: the force is the same.
TEST(ElasticForce, OfSolidRowsNeedsNoFraction) {
  Domain d(MPI_COMM_WORLD, {14, 10, 13}, {}, support::faces(10, 2, 1.4));
  const auto& g = d.grid;
  const InterfaceShare share(kFluidAtFlatInterface, g);
  Material m = half_solid(d);
  ElasticForce with({Real(2.5)}, share, g), without({Real(2.5)}, share, g);
  for (int k = 0; k < g.nz; ++k) with.find(m, 1, k);
  m.all_solid_from = kAllSolidFrom;
  for (int k = 0; k < g.nz; ++k) without.find(m, 1, k);
  for (const auto component : {&grid::VectorField::x, &grid::VectorField::y, &grid::VectorField::z}) {
    const auto whole = [&](const ElasticForce& force) {
      return support::global_values(force.now().*component, g, g.ny, d.decomposition.all());
    };
    EXPECT_LE(support::largest_difference(whole(with), whole(without)), support::round_off(100));
    EXPECT_GT(support::largest(whole(with)), 1);
  }
}

}  // namespace
}  // namespace softwall::solid
