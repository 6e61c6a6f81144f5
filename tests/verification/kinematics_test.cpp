#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/carried_solid.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/physics.hpp"
#include "tests/support/reversing_vortex.hpp"

// Vortices that turn a solid and turn it back, and steady ones in which every particle's deformation is
// known.
namespace softwall::solid {
namespace {

using support::Domain;
using support::kCenter;

constexpr double kPi = std::numbers::pi;

struct Reversing {
  double returned = 0;     ///< largest |B - I| after the flow has come back
  double determinant = 0;  ///< largest |det B - 1| half way
};

double worst_deformation(const Material& m, const Domain& d) {
  const auto deviation = [&](const grid::Field& f, double rest) {
    return support::largest_error(f, d.grid, kCenter, d.decomposition,
                                  [=](double, double, double) { return rest; });
  };
  double worst = 0;
  for (const grid::Field* f : {&m.B.xx, &m.B.yy, &m.B.zz}) worst = support::worse(worst, deviation(*f, 1));
  for (const grid::Field* f : {&m.B.xy, &m.B.xz, &m.B.yz}) worst = support::worse(worst, deviation(*f, 0));
  return worst;
}

/// `unit` turns the solid, slowing to a halt at t = 1/2 and turning back.
Reversing turn_and_return(Domain& d, const grid::VectorField& unit, int steps) {
  support::ReversingVelocity velocity(unit, d.grid);
  Reversing result;
  Material m = support::solid_everywhere(d.grid);
  Solid solid(support::carried_spec(), d.grid, d.decomposition, d.halo);
  support::carry(solid, m, 0.5, steps / 2,
                 [&](double t) -> const grid::VectorField& { return velocity.at(t); });
  EXPECT_GT(worst_deformation(m, d), 0.3) << "the flow must deform the solid for the test to mean anything";
  result.determinant = support::worst_determinant(m, d);
  support::carry(solid, m, 0.5, steps / 2,
                 [&](double t) -> const grid::VectorField& { return velocity.at(0.5 + t); });
  result.returned = worst_deformation(m, d);
  return result;
}

/// The velocity of a stream function on the edges along y, between walls that slip: discretely solenoidal.
Reversing vortex_in_xz(int n) {
  Domain d(MPI_COMM_WORLD, {n, 3, n}, {1, 1}, support::faces(3, 1));
  const auto& g = d.grid;
  const auto psi = [&](int i, int k) { return std::sin(2 * kPi * i / n) * std::sin(2 * kPi * k / n) / 20; };
  grid::VectorField unit(g, 1);
  support::set_by_index(unit.x, g, g.ny,
                        [&](int i, int, int k) { return (psi(i, k + 1) - psi(i, k)) / g.dz; });
  support::set_by_index(unit.z, g, g.ny,
                        [&](int i, int, int k) { return -(psi(i + 1, k) - psi(i, k)) / g.dx; });
  for (grid::Field* f : {&unit.x, &unit.z}) {  // walls that slip: nothing depends on y
    fluid::fill_ghosts(*f, d.halo);
  }
  return turn_and_return(d, unit, 2 * n);
}

Reversing vortex_in_xy(int n, double stretching) {
  Domain d(MPI_COMM_WORLD, {n, n, 3 * support::world_size()}, {1, 1}, support::faces(n, 1, stretching));
  return turn_and_return(d, support::vortex_in_xy(d), 2 * n);
}

template <class Run>
void expect_second_order(const std::string& name, const Run& run, int coarse = 16) {
  std::vector<double> determinant, returned;
  for (const int n : {coarse, 2 * coarse, 4 * coarse}) {
    const Reversing r = run(n);
    determinant.push_back(r.determinant);
    returned.push_back(r.returned);
  }
  support::expect_order("reversing vortex " + name + ", max |det B - 1|", determinant, 1.9);
  support::expect_order("reversing vortex " + name + ", max |B - I| after the return", returned, 1.9);
}

TEST(ReversingVortex, InXzReturnsToTheIdentityAndKeepsVolume) {
  expect_second_order("in xz", vortex_in_xz, 24);
}
TEST(ReversingVortex, InXyReturnsToTheIdentityAndKeepsVolume) {
  expect_second_order("in xy", [](int n) { return vortex_in_xy(n, 0); });
}
TEST(ReversingVortex, OnAStretchedGridToo) {
  expect_second_order(
      "in xy, stretched", [](int n) { return vortex_in_xy(n, 1.2); }, 24);
}

/// A steady plane flow u = (dpsi/dq, -dpsi/dp), psi = A sin(a p) sin(a q): pure strain where four cells meet,
/// rigid rotation in their middle, shear in between.
struct Cells {
  double A, a;
  double psi(double p, double q) const { return A * std::sin(a * p) * std::sin(a * q); }
  std::array<double, 2> velocity(const std::array<double, 2>& x) const {
    return {A * a * std::sin(a * x[0]) * std::cos(a * x[1]),
            -A * a * std::cos(a * x[0]) * std::sin(a * x[1])};
  }
  /// du_r/dx_s, row by row.
  std::array<double, 4> gradient(const std::array<double, 2>& x) const {
    const double both = A * a * a * std::cos(a * x[0]) * std::cos(a * x[1]),
                 none = A * a * a * std::sin(a * x[0]) * std::sin(a * x[1]);
    return {both, -none, none, -both};
  }
};

/// B of the particle that is at x after time T: followed back to its origin X with H = dX/dx,
/// dX/dt = -u(X), dH/dt = -grad u(X) H, by fourth-order Runge-Kutta; then B = (H^T H)^-1 for a start with B =
/// I. Returns B_pp, B_pq, B_qq.
std::array<double, 3> exact_deformation(const Cells& flow, const std::array<double, 2>& x, double T) {
  using Particle = std::array<double, 6>;  // X, H row by row
  const auto rate = [&](const Particle& s) -> Particle {
    const auto u = flow.velocity({s[0], s[1]});
    const auto L = flow.gradient({s[0], s[1]});
    return {-u[0],
            -u[1],
            -(L[0] * s[2] + L[1] * s[4]),
            -(L[0] * s[3] + L[1] * s[5]),
            -(L[2] * s[2] + L[3] * s[4]),
            -(L[2] * s[3] + L[3] * s[5])};
  };
  const auto moved = [](const Particle& s, double h, const Particle& r) {
    Particle out = s;
    for (std::size_t n = 0; n < out.size(); ++n) out[n] += h * r[n];
    return out;
  };
  Particle s{x[0], x[1], 1, 0, 0, 1};
  constexpr int kSteps = 100;
  const double h = T / kSteps;
  for (int step = 0; step < kSteps; ++step) {
    const Particle r1 = rate(s), r2 = rate(moved(s, h / 2, r1)), r3 = rate(moved(s, h / 2, r2)),
                   r4 = rate(moved(s, h, r3));
    for (std::size_t n = 0; n < s.size(); ++n) s[n] += h / 6 * (r1[n] + 2 * r2[n] + 2 * r3[n] + r4[n]);
  }
  const double pp = s[2] * s[2] + s[4] * s[4], pq = s[2] * s[3] + s[4] * s[5], qq = s[3] * s[3] + s[5] * s[5];
  return {qq, -pq, pp};  // det H = 1
}

constexpr double kSteadyTime = 1;
constexpr Cells kSteadyCells{1.0 / 40, 2 * kPi};
constexpr double kSteadyRate = kSteadyCells.A * kSteadyCells.a * kSteadyCells.a;  ///< of strain, of rotation

/// B after kSteadyTime, from the start B_xx = stretch, B_zz = 1 / stretch.
Material deformed_by_cells(Domain& d, double stretch) {
  const auto& g = d.grid;
  // psi on xz edges, half a cell off the pattern's nodes: cell centers lie on saddles and middles.
  const auto psi = [&](int i, int k) { return kSteadyCells.psi((i - 0.5) * g.dx, (k - 0.5) * g.dz); };
  grid::VectorField velocity(g, 1);
  support::set_by_index(velocity.x, g, g.ny,
                        [&](int i, int, int k) { return (psi(i, k + 1) - psi(i, k)) / g.dz; });
  support::set_by_index(velocity.z, g, g.ny,
                        [&](int i, int, int k) { return -(psi(i + 1, k) - psi(i, k)) / g.dx; });
  for (grid::Field* f : {&velocity.x, &velocity.z}) fluid::fill_ghosts(*f, d.halo);  // walls that slip
  Material m = support::solid_everywhere(g);
  support::set_by_index(m.B.xx, g, g.ny, [=](int, int, int) { return stretch; });
  support::set_by_index(m.B.zz, g, g.ny, [=](int, int, int) { return 1 / stretch; });
  Solid solid(support::carried_spec(), g, d.decomposition, d.halo);
  support::carry(solid, m, kSteadyTime, 2 * g.nx,
                 [&](double) -> const grid::VectorField& { return velocity; });
  return m;
}

/// Largest error of a component of B of the undeformed start.
double error_of_cells(const Material& m, const grid::Grid& g) {
  double largest = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int i = 0; i < g.nx; ++i) {
      const std::array<double, 2> center{i * g.dx, k * g.dz};
      const std::array<double, 2> edge{center[0] - g.dx / 2, center[1] - g.dz / 2};
      const auto at_center = exact_deformation(kSteadyCells, center, kSteadyTime);
      const auto at_edge = exact_deformation(kSteadyCells, edge, kSteadyTime);
      largest = support::worse(largest, std::abs(m.B.xx(i, 1, k) - at_center[0]));
      largest = support::worse(largest, std::abs(m.B.zz(i, 1, k) - at_center[2]));
      largest = support::worse(largest, std::abs(m.B.xz(i, 1, k) - at_edge[1]));
    }
  }
  return largest;
}

TEST(SteadyCells, DeformEveryParticleAsItsPathSays) {
  std::vector<double> everywhere, strain, rotation;
  for (const int n : {16, 32, 64}) {
    Domain d(MPI_COMM_WORLD, {n, 3, n}, {1, 1}, support::faces(3, 1));
    const Material undeformed = deformed_by_cells(d, 1), stretched = deformed_by_cells(d, 2);
    everywhere.push_back(error_of_cells(undeformed, d.grid));
    strain.push_back(std::abs(undeformed.B.xx(0, 1, 0) / std::exp(2 * kSteadyRate * kSteadyTime) - 1));
    const double angle = kSteadyRate * kSteadyTime, c = std::cos(angle), s = std::sin(angle);
    const auto middle = tensor_at_center(stretched.B, n / 4, 1, n / 4);
    rotation.push_back(
        std::max({std::abs(middle.xx - 2 * c * c - s * s / 2), std::abs(middle.zz - 2 * s * s - c * c / 2),
                  std::abs(middle.xz - 1.5 * s * c)}));
    const auto unturned = tensor_at_center(undeformed.B, n / 4, 1, n / 4);
    EXPECT_NEAR(unturned.xx, 1, 1e-12) << "rigid rotation does not deform";
    EXPECT_NEAR(unturned.zz, 1, 1e-12);
    EXPECT_NEAR(unturned.xz, 0, 1e-12);
  }
  support::expect_order("steady cells, max |B - exact|", everywhere, 1.9);
  support::expect_order("steady cells, pure strain at the saddle", strain, 1.9);
  support::expect_order("steady cells, rotation of a stretched solid", rotation, 1.9);
}

}  // namespace
}  // namespace softwall::solid
