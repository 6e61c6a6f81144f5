#include "solver/solid/transported_b/skin.hpp"

#include <gtest/gtest.h>

#include "tests/support/stretching_views.hpp"

// B comes from the row above wherever phi is below the threshold, there or at any place above in the column.
namespace softwall::solid {
namespace {

using support::Domain;

class Skin : public testing::Test {
 protected:
  static constexpr Real kThreshold = 0.5;
  Domain d{MPI_COMM_WORLD, {12, 10, 7}, {}, support::faces(10)};
  Material m{d.grid};

  /// Every component its own number in every place, so that copies can be told apart.
  static Real label(int component, int i, int j, int k) {
    return component + 10 * (i + 100 * (j + 100.0 * k));
  }
  void label_all() {
    int component = 0;
    for (grid::Field* f : components()) {
      support::set_by_index(*f, d.grid, d.grid.ny + 1,
                            [=](int i, int j, int k) { return label(component, i, j, k); });
      ++component;
    }
  }
  std::array<grid::Field*, 6> components() { return {&m.B.xx, &m.B.yy, &m.B.zz, &m.B.xy, &m.B.xz, &m.B.yz}; }
  void extend_into_fluid(const grid::Box& box) {
    constexpr Real kAnything = -1e12;  // the labels are no tensors
    extend_shear(m, kThreshold, d.grid, box);
    EXPECT_EQ(extend_normal(m, kThreshold, kAnything, d.grid, box), 0);
  }
  template <class Value>
  void set_fraction(const Value& value) {
    support::set_by_index(m.phi, d.grid, d.grid.ny, value);
    fluid::fill_ghosts(m.phi, d.halo);
  }
};

TEST_F(Skin, CopiesDownBelowAFlatInterface) {
  const int interface =
      6;  // phi = 1 from this row on: shear on face 6 sees the mean 1/2, not below the threshold
  set_fraction([=](int, int j, int) { return j >= interface ? 1.0 : 0.0; });
  label_all();
  extend_into_fluid(grid::rows(d.grid, 2, d.grid.ny));
  int component = 0;
  for (grid::Field* f : components()) {
    for (int j = 0; j < d.grid.ny; ++j) {
      const int source = j < 2 || j >= interface ? j : interface;  // rows below the box stay as they are
      ASSERT_EQ((*f)(1, j, 1), label(component, d.grid.x_begin + 1, source, d.grid.z_begin + 1))
          << component << ' ' << j;
    }
    ++component;
  }
}

TEST_F(Skin, ColumnsDoNotKnowOfEachOther) {
  const auto interface = [](int i, int k) { return 4 + (i + 2 * k) % 4; };
  set_fraction([=](int i, int j, int k) { return j >= interface(i, k) ? 1.0 : 0.0; });
  label_all();
  extend_into_fluid(grid::rows(d.grid, 0, d.grid.ny));
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i) {
        const int x = d.grid.x_begin + i, z = d.grid.z_begin + k;
        ASSERT_EQ(m.B.yy(i, j, k), label(1, x, std::max(j, interface(x, z)), z));
      }
    }
  }
}

TEST_F(Skin, AHoleInTheSolidTakesWhatIsAboveItAndSoDoesAllBelow) {
  set_fraction([](int, int j, int) { return j == 5 ? 0.2 : 1.0; });
  label_all();
  extend_into_fluid(grid::rows(d.grid, 0, d.grid.ny));
  for (int j = 0; j < d.grid.ny; ++j) {
    EXPECT_EQ(m.B.xx(1, j, 1), label(0, d.grid.x_begin + 1, j <= 5 ? 6 : j, d.grid.z_begin + 1)) << j;
  }
}

TEST_F(Skin, SolidEverywhereIsLeftAlone) {
  set_fraction([](int, int, int) { return 1.0; });
  label_all();
  extend_into_fluid(grid::rows(d.grid, 0, d.grid.ny));
  for (int j = 0; j < d.grid.ny; ++j) {
    EXPECT_EQ(m.B.xx(2, j, 2), label(0, d.grid.x_begin + 2, j, d.grid.z_begin + 2));
    EXPECT_EQ(m.B.yz(2, j, 2), label(5, d.grid.x_begin + 2, j, d.grid.z_begin + 2));
  }
}

TEST_F(Skin, AppliedTwiceChangesNothingMore) {
  set_fraction([](int i, int j, int k) {
    return std::clamp(j / 5.0 - 0.5 + 0.2 * support::noise(1, i, 0, k), 0.0, 1.0);
  });
  label_all();
  const auto box = grid::rows(d.grid, 1, d.grid.ny);
  extend_into_fluid(box);
  std::vector<std::vector<double>> once;
  for (grid::Field* f : components())
    once.push_back(support::global_values(*f, d.grid, d.grid.ny + 1, d.decomposition.all()));
  extend_into_fluid(box);
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(support::global_values(*components()[c], d.grid, d.grid.ny + 1, d.decomposition.all()),
              once[c]);
  }
}

TEST_F(Skin, LimitedSolidIsCopiedDownAsItIs) {
  // Copies of cells that the limiter has raised, and copies that it must raise in their own turn: again, not
  // one bit may change when all is done twice.
  set_fraction([](int i, int j, int k) {
    return std::clamp(j / 5.0 - 0.5 + 0.4 * support::noise(1, i, 0, k), 0.0, 1.0);
  });
  int seed = 2;
  for (grid::Field* f : components()) {
    const bool normal = f == &m.B.xx || f == &m.B.yy || f == &m.B.zz;
    support::set_by_index(*f, d.grid, d.grid.ny + 1, [=](int i, int j, int k) {
      return (normal ? 1 : 0) + (normal ? 0.5 : 1.5) * support::noise(seed, i, j, k);
    });
    ++seed;
  }
  const auto box = grid::rows(d.grid, 0, d.grid.ny);
  const auto settle = [&] {
    extend_shear(m, kThreshold, d.grid, box);
    fluid::fill_ghosts(m.B.xz, d.halo);
    d.halo.fill({&m.B.xy, &m.B.yz}, {0, d.grid.ny + 1});
    return extend_normal(m, kThreshold, 0.1, d.grid, box);
  };
  const auto everything = [&] {
    std::vector<std::vector<double>> values;
    for (grid::Field* f : components())
      values.push_back(support::global_values(*f, d.grid, d.grid.ny, d.decomposition.all()));
    return values;
  };
  ASSERT_GT(settle(), 0);
  const auto once = everything();
  settle();
  EXPECT_EQ(everything(), once);
}

}  // namespace
}  // namespace softwall::solid
