#include <gtest/gtest.h>

#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/solids.hpp"

namespace softwall::time {
namespace {

/// Every number of a field that the state keeps equals `value(j)`, to the last bit.
template <class Value>
void expect_exactly(const grid::Field& f, const grid::Grid& g, int rows, const Value& value) {
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < g.nx; ++i) ASSERT_EQ(f(i, j, k), value(j)) << i << ' ' << j << ' ' << k;
    }
  }
}

void expect_rest(const SolidSpec& solid_spec, double viscosity_ratio, double stretching) {
  Physics p = support::elastic_channel({12, 12, 4, 9});
  p.solid = support::made_of(solid_spec, 4, viscosity_ratio);
  p.grid.stretching = stretching;
  p.layer_height = 0.5;
  Setup setup(p, MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  State s = state_at_rest(setup);
  start(s, setup);
  for (int step = 0; step < 100; ++step) advance(s, setup, 0.01);
  const auto& g = setup.grid;
  const auto zero = [](int) { return 0.0; };
  expect_exactly(s.velocity.x, g, g.ny, zero);
  expect_exactly(s.velocity.y, g, g.ny + 1, zero);
  expect_exactly(s.velocity.z, g, g.ny, zero);
  const SolidInput solid = setup.solid->input(s.material);
  for (const auto* force : {solid.force_now, solid.force_before}) {
    expect_exactly(force->x, g, g.ny, zero);
    expect_exactly(force->y, g, g.ny, zero);
    expect_exactly(force->z, g, g.ny, zero);
  }
  expect_exactly(s.material.phi, g, g.ny, [&](int j) { return j < g.ny_fluid ? 0.0 : 1.0; });
  for (const grid::Field* shear : {&s.material.B.xy, &s.material.B.xz, &s.material.B.yz})
    expect_exactly(*shear, g, g.ny, zero);
  for (const grid::Field* normal : {&s.material.B.xx, &s.material.B.yy, &s.material.B.zz}) {
    for (int j = g.ny_fluid; j < g.ny; ++j) ASSERT_EQ((*normal)(0, j, 0), 1.0);
  }
  EXPECT_EQ(setup.solid->limited_cells(), 0);
}

class LayerAtRest : public testing::TestWithParam<support::NamedSolid> {};

TEST_P(LayerAtRest, StaysExactlyAtRest) { expect_rest(GetParam().spec, 1, 0); }
TEST_P(LayerAtRest, StaysExactlyAtRestWithAnotherViscosityOnAStretchedGrid) {
  expect_rest(GetParam().spec, 10, 1.2);
}

INSTANTIATE_TEST_SUITE_P(, LayerAtRest, testing::ValuesIn(support::solids()), support::solid_name);

}  // namespace
}  // namespace softwall::time
