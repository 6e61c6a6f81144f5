#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "tests/support/flows.hpp"
#include "tests/support/solids.hpp"

// As symmetry_test.cpp, for a layer that is deformed already: every field of the state is transformed, the
// tensor with its indices, and must come out transformed.
namespace softwall::time {
namespace {

constexpr int kN = 12;  // cells in x and in z

/// Where a field lives and how it transforms: whether on the low face in x and z, its indices (0 x, 1 y, 2
/// z).
struct Kind {
  bool on_x_face = false, on_z_face = false;
  std::vector<int> indices;
};

Kind kind_of(const std::string& name) {
  if (name == "u") return {true, false, {0}};
  if (name == "v") return {false, false, {1}};
  if (name == "w") return {false, true, {2}};
  if (name == "d_x") return {true, false, {0}};
  if (name == "d_y") return {false, false, {1}};
  if (name == "d_z") return {false, true, {2}};
  if (name == "B_xx") return {false, false, {0, 0}};
  if (name == "B_yy") return {false, false, {1, 1}};
  if (name == "B_zz") return {false, false, {2, 2}};
  if (name == "B_xy") return {true, false, {0, 1}};
  if (name == "B_xz") return {true, true, {0, 2}};
  if (name == "B_yz") return {false, true, {1, 2}};
  return {};  // scalars at centers
}

/// A map of the periodic plane onto itself: shift by cells, then mirror, then exchange of x and z.
struct Map {
  const char* name;
  int shift_x = 0, shift_z = 0;
  bool mirror_x = false, mirror_z = false, exchange = false;
};

struct Named {
  std::string name;
  int rows;
  std::vector<double> values;  ///< (nz, rows, nx)
};

std::vector<Named> contents(State& s, const Setup& setup) {
  std::vector<Named> all;
  for (const auto& f : fields_of(s))
    all.push_back(
        {f.name, f.rows, support::global_values(*f.field, setup.grid, f.rows, setup.decomposition.all())});
  return all;
}

/// The name of the field that takes this one's place when x and z are exchanged.
std::string exchanged(const std::string& name) {
  if (name == "u") return "w";
  if (name == "w") return "u";
  if (name == "d_x") return "d_z";
  if (name == "d_z") return "d_x";
  if (name == "B_xx") return "B_zz";
  if (name == "B_zz") return "B_xx";
  if (name == "B_xy") return "B_yz";
  if (name == "B_yz") return "B_xy";
  return name;
}

std::vector<Named> transformed(const std::vector<Named>& from, const Map& map) {
  std::vector<Named> to = from;
  const auto wrap = [](int index) { return static_cast<std::size_t>(((index % kN) + kN) % kN); };
  for (Named& out : to) {
    const std::string source_name = map.exchange ? exchanged(out.name) : out.name;
    const auto& in =
        *std::find_if(from.begin(), from.end(), [&](const Named& n) { return n.name == source_name; });
    const Kind kind = kind_of(source_name);
    double sign = 1;
    for (const int index : kind.indices) {
      if ((index == 0 && map.mirror_x) || (index == 2 && map.mirror_z)) sign = -sign;
    }
    std::size_t n = 0;
    for (int k = 0; k < kN; ++k) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(out.rows); ++j) {
        for (int i = 0; i < kN; ++i) {
          int a = map.exchange ? k : i, c = map.exchange ? i : k;
          if (map.mirror_x) a = (kind.on_x_face ? 0 : -1) - a;
          if (map.mirror_z) c = (kind.on_z_face ? 0 : -1) - c;
          const std::size_t row = wrap(c - map.shift_z) * static_cast<std::size_t>(out.rows) + j;
          out.values[n++] = sign * in.values[row * kN + wrap(a - map.shift_x)];
        }
      }
    }
  }
  return to;
}

void put(const std::vector<Named>& values, State& s, const Setup& setup) {
  std::size_t field = 0;
  for (const auto& f : fields_of(s)) {
    const Named& from = values[field++];
    support::set_by_index(*f.field, setup.grid, f.rows, [&](int i, int j, int k) {
      return from.values[(static_cast<std::size_t>(k) * static_cast<std::size_t>(f.rows) +
                          static_cast<std::size_t>(j)) *
                             kN +
                         static_cast<std::size_t>(i)];
    });
  }
}

class DeformedLayer : public testing::TestWithParam<std::tuple<Map, support::NamedSolid>> {
 protected:
  static Physics physics() {
    Physics p = support::elastic_channel({kN, 10, 4, kN});
    p.length_x = p.length_z = 2;
    p.solid = support::made_of(std::get<support::NamedSolid>(GetParam()).spec, 0.3, 3);
    return p;
  }
  static void advance_by(State& s, time::Setup& setup, int steps) {
    for (int step = 0; step < steps; ++step) advance(s, setup, 0.01);
  }
  static std::vector<Named> later(const std::vector<Named>& from) {
    time::Setup setup(physics(), MPI_COMM_WORLD);
    setup.bulk_velocity.reset();
    State s = state_at_rest(setup);
    put(from, s, setup);
    start(s, setup);
    advance_by(s, setup, 10);
    return contents(s, setup);
  }
};

TEST_P(DeformedLayer, KnowsNoLeftAndRight) {
  time::Setup setup(physics(), MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  State s = support::smooth_state(setup);
  advance_by(s, setup, 40);
  const auto deformed = contents(s, setup);
  const auto partly = [](double phi) { return 0.1 < phi && phi < 0.9; };
  const auto phi =
      support::global_values(s.material.phi, setup.grid, setup.grid.ny, setup.decomposition.all());
  ASSERT_TRUE(std::any_of(phi.begin(), phi.end(), partly)) << "the interface is still flat";
  const auto& map = std::get<Map>(GetParam());
  const auto plain = later(deformed), expected = transformed(plain, map);
  const auto seen = later(transformed(deformed, map));
  double change = 0;
  for (std::size_t f = 0; f < seen.size(); ++f) {
    EXPECT_LT(support::largest_difference(seen[f].values, expected[f].values), 1e-11) << seen[f].name;
    change = std::max(change, support::largest_difference(expected[f].values, plain[f].values));
  }
  EXPECT_GT(change, 0.1) << "nothing was tested";
}

constexpr Map kMaps[]{{.name = "Shifted", .shift_x = 5, .shift_z = -4},
                      {.name = "MirroredInZ", .mirror_z = true},
                      {.name = "MirroredInX", .mirror_x = true},
                      {.name = "XForZ", .exchange = true}};

std::vector<support::NamedSolid> all_solids() {
  auto all = support::solids();
  auto sharp = all.front();
  sharp.name = "SharpTransportedB";
  sharp.spec.interface = InterfaceTransport::kMthinc;
  all.push_back(sharp);
  for (const std::size_t formulation : {0, 1}) {
    all.push_back(all[formulation]);
    all.back().name = "MooneyRivlin" + all.back().name;
    all.back().spec.mooney_share = 0.5;
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(, DeformedLayer,
                         testing::Combine(testing::ValuesIn(kMaps), testing::ValuesIn(all_solids())),
                         [](const auto& test) {
                           return std::string(std::get<Map>(test.param).name) + "Of" +
                                  std::get<support::NamedSolid>(test.param).name;
                         });

}  // namespace
}  // namespace softwall::time
