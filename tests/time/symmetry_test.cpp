#include <gtest/gtest.h>

#include "tests/support/flows.hpp"

// The equations know no left and right, no first cell and no name of x and z: neither may the code.
namespace softwall::time {
namespace {

constexpr int kN = 12;  // cells in x and in z

using Index = std::array<int, 3>;

int wrap(int index, int n) { return ((index % n) + n) % n; }

/// A velocity component as a function of whole indices, rows from 0 on.
struct Component {
  std::vector<double> values;
  int nx, ny, nz;
  double operator()(int i, int j, int k) const {
    return values[(static_cast<std::size_t>(wrap(k, nz)) * static_cast<std::size_t>(ny) +
                   static_cast<std::size_t>(j)) *
                      static_cast<std::size_t>(nx) +
                  static_cast<std::size_t>(wrap(i, nx))];
  }
};

Component component(const grid::Field& f, const Setup& setup, int rows) {
  return {support::global_values(f, setup.grid, rows, setup.decomposition.all()), setup.grid.nx_global, rows,
          setup.grid.nz_global};
}

/// The start, in one place: u, v, w of the smooth flow, solenoidal.
struct Start {
  Component u, v, w;
};

Start smooth_start(const Physics& p) {
  time::Setup setup(p, MPI_COMM_WORLD);
  const State s = support::smooth_state(setup);
  return {component(s.velocity.x, setup, setup.grid.ny), component(s.velocity.y, setup, setup.grid.ny + 1),
          component(s.velocity.z, setup, setup.grid.ny)};
}

Start after(const Physics& p, int steps, bool driven, bool filled_with_solid, const Start& start_velocity) {
  time::Setup setup(p, MPI_COMM_WORLD);
  if (!driven) setup.bulk_velocity.reset();
  State s = state_at_rest(setup);
  if (filled_with_solid) s.material = support::solid_everywhere(setup.grid, p.solid->formulation);
  const auto& g = setup.grid;
  support::set_by_index(s.velocity.x, g, g.ny, start_velocity.u);
  support::set_by_index(s.velocity.y, g, g.ny + 1, start_velocity.v);
  support::set_by_index(s.velocity.z, g, g.ny, start_velocity.w);
  start(s, setup);
  for (int step = 0; step < steps; ++step) advance(s, setup, 0.01);
  return {component(s.velocity.x, setup, g.ny), component(s.velocity.y, setup, g.ny + 1),
          component(s.velocity.z, setup, g.ny)};
}

/// One component seen through a map of indices, with a sign.
template <class Map>
Component seen(const Component& c, double sign, const Map& map) {
  Component out = c;
  std::size_t n = 0;
  for (int k = 0; k < c.nz; ++k) {
    for (int j = 0; j < c.ny; ++j) {
      for (int i = 0; i < c.nx; ++i) {
        const Index from = map(Index{i, j, k});
        out.values[n++] = sign * c(from[0], from[1], from[2]);
      }
    }
  }
  return out;
}

void expect_same(const Start& a, const Start& b) {
  EXPECT_LT(support::largest_difference(a.u.values, b.u.values), 1e-12);
  EXPECT_LT(support::largest_difference(a.v.values, b.v.values), 1e-12);
  EXPECT_LT(support::largest_difference(a.w.values, b.w.values), 1e-12);
}

Start shifted(const Start& s) {
  const auto map = [](const Index& at) { return Index{at[0] - 5, at[1], at[2] + 4}; };
  return {seen(s.u, 1, map), seen(s.v, 1, map), seen(s.w, 1, map)};
}
Start upside_down(const Start& s) {
  const int ny = s.u.ny;
  const auto center = [=](const Index& at) { return Index{at[0], ny - 1 - at[1], at[2]}; };
  const auto face = [=](const Index& at) { return Index{at[0], ny - at[1], at[2]}; };
  return {seen(s.u, 1, center), seen(s.v, -1, face), seen(s.w, 1, center)};
}
/// Mirrored in z: w lives on faces, which change places otherwise than centers.
Start other_hand(const Start& s) {
  const auto center = [](const Index& at) { return Index{at[0], at[1], -1 - at[2]}; };
  const auto face = [](const Index& at) { return Index{at[0], at[1], -at[2]}; };
  return {seen(s.u, 1, center), seen(s.v, 1, center), seen(s.w, -1, face)};
}
Start backwards(const Start& s) {
  const auto center = [](const Index& at) { return Index{-1 - at[0], at[1], at[2]}; };
  const auto face = [](const Index& at) { return Index{-at[0], at[1], at[2]}; };
  return {seen(s.u, -1, face), seen(s.v, 1, center), seen(s.w, 1, center)};
}
Start x_for_z(const Start& s) {
  const auto map = [](const Index& at) { return Index{at[2], at[1], at[0]}; };
  return {seen(s.w, 1, map), seen(s.v, 1, map), seen(s.u, 1, map)};
}

struct Flow {
  const char* name;
  bool elastic, filled;
  SolidFormulation formulation = SolidFormulation::kTransportedB;
};

/// A cube-like box, so that x and z may change places.
Physics physics(const Flow& flow) {
  Physics p = flow.filled    ? support::solid_box({kN, 10, 0, kN})
              : flow.elastic ? support::elastic_channel({kN, 10, 4, kN})
                             : support::rigid_channel({kN, 10, 0, kN});
  if (!flow.elastic) p.grid.stretching = 1.3;
  if (flow.elastic) p.solid->formulation = flow.formulation;
  p.length_x = p.length_z = 2;
  return p;
}

class Symmetry : public testing::TestWithParam<Flow> {
 protected:
  template <class Transformation>
  void expect_commutes(const Transformation& t, bool driven) {
    const Physics p = physics(GetParam());
    const Start from = smooth_start(p);
    const bool filled = GetParam().filled;
    const Start there = after(p, 20, driven, filled, from);
    expect_same(after(p, 20, driven, filled, t(from)), t(there));
    EXPECT_GT(support::largest_difference(t(there).u.values, there.u.values), 1e-3) << "nothing was tested";
  }
};

TEST_P(Symmetry, ShiftByWholeCells) { expect_commutes(shifted, !GetParam().filled); }
TEST_P(Symmetry, LeftForRight) { expect_commutes(other_hand, !GetParam().filled); }
TEST_P(Symmetry, Backwards) { expect_commutes(backwards, false); }
TEST_P(Symmetry, XForZ) { expect_commutes(x_for_z, false); }
TEST_P(Symmetry, UpsideDown) {
  if (GetParam().elastic && !GetParam().filled) GTEST_SKIP() << "the layer hangs at the top";
  expect_commutes(upside_down, !GetParam().elastic);
}

INSTANTIATE_TEST_SUITE_P(
    Flows, Symmetry,
    testing::Values(Flow{"RigidChannel", false, false}, Flow{"ElasticChannel", true, false},
                    Flow{"SolidBox", true, true},
                    Flow{"ElasticChannelWithAReferenceMap", true, false, SolidFormulation::kReferenceMap},
                    Flow{"SolidBoxWithAReferenceMap", true, true, SolidFormulation::kReferenceMap}),
    [](const auto& flow) { return std::string(flow.param.name); });

}  // namespace
}  // namespace softwall::time
