#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/convergence.hpp"
#include "tests/support/slip_flow.hpp"

// Decaying Taylor-Green vortices, carried along by a uniform stream: exact solutions of the whole equations.
//   stream function sin(a (p - P t)) sin(b (q - Q t)) exp(-nu (a^2 + b^2) t) in the plane (p, q)
namespace softwall {
namespace {

using support::Domain;
using support::kFaceX;
using support::kFaceY;
using support::kFaceZ;

constexpr double kPi = std::numbers::pi, kNu = 0.005, kEnd = 0.5;

/// One wave in each direction of the plane; p runs along the first axis of the name, q along the second.
struct Vortex {
  double a, b;  ///< wave numbers
  double P, Q;  ///< the stream
  double along_p(double p, double q, double t) const {
    return P + std::sin(a * (p - P * t)) * std::cos(b * (q - Q * t)) * decay(t);
  }
  double along_q(double p, double q, double t) const {
    return Q - a / b * std::cos(a * (p - P * t)) * std::sin(b * (q - Q * t)) * decay(t);
  }
  double decay(double t) const { return std::exp(-kNu * (a * a + b * b) * t); }
};

/// Sets the start, runs to kEnd and returns the largest error of all components.
template <class U, class V, class W>
double run(Domain& d, double dt, const U& u, const V& v, const W& w) {
  support::SlipFlow flow(d, kNu);
  const auto at = [](const auto& f, double t) {
    return [&f, t](double x, double y, double z) { return f(x, y, z, t); };
  };
  support::set_by_position(flow.velocity.x, d.grid, kFaceX, at(u, 0.0));
  support::set_by_position(flow.velocity.y, d.grid, kFaceY, at(v, 0.0));
  support::set_by_position(flow.velocity.z, d.grid, kFaceZ, at(w, 0.0));
  flow.fill_ghosts();
  const int steps = static_cast<int>(std::ceil(kEnd / dt));
  for (int step = 0; step < steps; ++step) flow.advance(kEnd / steps);
  const auto error = [&](const grid::Field& f, const support::Place& place, const auto& exact) {
    return support::largest_error(f, d.grid, place, d.decomposition, at(exact, kEnd));
  };
  return std::max({error(flow.velocity.x, kFaceX, u), error(flow.velocity.y, kFaceY, v),
                   error(flow.velocity.z, kFaceZ, w)});
}

double still(double, double, double, double) { return 0; }

double error_in_xz(int n) {
  const Domain::Lengths length{2, 1.5};
  Domain d(MPI_COMM_WORLD, {n, 3, n}, length, support::faces(3));
  const Vortex s{2 * kPi / length.x, 2 * kPi / length.z, 0.7, -0.4};
  return run(
      d, 0.3 / n, [=](double x, double, double z, double t) { return s.along_p(x, z, t); }, still,
      [=](double x, double, double z, double t) { return s.along_q(x, z, t); });
}

double error_in_xy(int n, double stretching) {
  const Domain::Lengths length{2, 1.5};
  Domain d(MPI_COMM_WORLD, {n, n, 3 * support::world_size()}, length, support::faces(n, 1.5, stretching));
  const Vortex s{2 * kPi / length.x, kPi / 1.5, 0.7, 0};
  return run(
      d, 0.3 / n, [=](double x, double y, double, double t) { return s.along_p(x, y, t); },
      [=](double x, double y, double, double t) { return s.along_q(x, y, t); }, still);
}

double error_in_yz(int n, double stretching) {
  const Domain::Lengths length{2, 1.5};
  Domain d(MPI_COMM_WORLD, {3, n, n}, length, support::faces(n, 1.5, stretching));
  const Vortex s{2 * kPi / length.z, kPi / 1.5, -0.6, 0};
  return run(
      d, 0.3 / n, still, [=](double, double y, double z, double t) { return s.along_q(z, y, t); },
      [=](double, double y, double z, double t) { return s.along_p(z, y, t); });
}

template <class ErrorOn>
void expect_second_order(const ErrorOn& error) {
  const double coarse = error(16), middle = error(32), fine = error(64);
  EXPECT_NEAR(support::observed_order(coarse, middle), 2, 0.3) << coarse << ' ' << middle;
  EXPECT_NEAR(support::observed_order(middle, fine), 2, 0.15) << middle << ' ' << fine;
  EXPECT_LT(fine, 5e-3);
  support::report("Taylor-Green, velocity", {coarse, middle, fine});
}

TEST(TaylorGreen, IsSecondOrderInXz) { expect_second_order(error_in_xz); }
TEST(TaylorGreen, IsSecondOrderInXy) {
  expect_second_order([](int n) { return error_in_xy(n, 0); });
}
TEST(TaylorGreen, IsSecondOrderInYz) {
  expect_second_order([](int n) { return error_in_yz(n, 0); });
}
TEST(TaylorGreen, IsSecondOrderInXyOnAStretchedGrid) {
  expect_second_order([](int n) { return error_in_xy(n, 1.2); });
}
TEST(TaylorGreen, IsSecondOrderInYzOnAStretchedGrid) {
  expect_second_order([](int n) { return error_in_yz(n, 1.2); });
}

}  // namespace
}  // namespace softwall
