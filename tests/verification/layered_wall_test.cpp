#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "solver/fluid/stability.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/solids.hpp"

// A wall oscillating in its plane under a layer of fluid, with a layer of solid between that and a wall at
// rest. Linear in the velocity at any amplitude; with s = i w, M = mu_s + G / s and the distance eta from the
// wall at rest, u = V Im[ U(eta) exp(i w t) ]:
//   solid, eta < hs:  U = A sinh(ks eta),                            ks = sqrt(s / M)
//   fluid, eta > hs:  U = A [ sinh(ks hs) cosh(kf z) + r sinh(kf z) ], z = eta - hs, kf = sqrt(s / mu_f)
//   r = M ks cosh(ks hs) / (mu_f kf),  A = 1 / [ sinh(ks hs) cosh(kf hf) + r sinh(kf hf) ]
// The solid is at the top here, so y = H - eta and B_xy = -Im[ U'(eta) exp(i w t) / (i w) ].
namespace softwall::time {
namespace {

using Complex = std::complex<double>;

/// Depths, viscosities, modulus and frequency in any units with rho = V = 1.
struct Layers {
  const char* name;
  double w, hs, hf, mu_f, mu_s, G;

  /// In the units of the code, where the fluid is 2 deep and V stays 1.
  Layers scaled() const {
    const double length = 2 / hf;
    return {name, w / length, hs * length, 2, mu_f * length, mu_s * length, G};
  }
};

class OscillatingWall {
 public:
  explicit OscillatingWall(const Layers& l)
      : l_(l), s_(0, l.w), M_(l.mu_s + l.G / s_), ks_(std::sqrt(s_ / M_)), kf_(std::sqrt(s_ / l.mu_f)) {
    r_ = M_ * ks_ * std::cosh(ks_ * l.hs) / (l.mu_f * kf_);
    A_ = 1.0 / (std::sinh(ks_ * l.hs) * std::cosh(kf_ * l.hf) + r_ * std::sinh(kf_ * l.hf));
  }
  double velocity(double y, double t) const {
    const double eta = l_.hf + l_.hs - y;
    const Complex z = kf_ * (eta - l_.hs);
    const Complex U = eta < l_.hs ? A_ * std::sinh(ks_ * eta)
                                  : A_ * (std::sinh(ks_ * l_.hs) * std::cosh(z) + r_ * std::sinh(z));
    return std::imag(U * std::exp(s_ * t));
  }
  /// In the solid.
  double displacement(double y, double t) const {
    return std::imag(A_ * std::sinh(ks_ * (l_.hf + l_.hs - y)) / s_ * std::exp(s_ * t));
  }
  double shear(double y, double t) const { return -std::imag(shear_amplitude(y) * std::exp(s_ * t)); }
  Complex shear_amplitude(double y) const { return A_ * ks_ * std::cosh(ks_ * (l_.hf + l_.hs - y)) / s_; }

 private:
  Layers l_;
  Complex s_, M_, ks_, kf_, r_, A_;
};

struct Errors {
  double velocity = 0;  ///< over the wall's
  double shear = 0;     ///< of B_xy inside the solid, over its amplitude
  double stretch = 0;   ///< of B_xx inside the solid, which is near 1
};

/// From the exact state at t = 0 through half a period and a bit more.
Errors run(const Layers& given, const SolidSpec& solid, int cells) {
  const Layers l = given.scaled();
  const int ny_solid = static_cast<int>(std::lround(cells * l.hs / (l.hs + l.hf)));
  Physics p = support::elastic_channel({1, cells - ny_solid, ny_solid, 1});
  p.reynolds = 1 / l.mu_f;
  p.layer_height = l.hs;
  p.solid = support::made_of(solid, l.G, std::max(l.mu_s / l.mu_f, 1e-9));
  time::Setup setup(p, MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  const auto& g = setup.grid;
  const OscillatingWall exact(l);
  const auto velocity_at = [&](double t) {
    return [&exact, t](double, double y, double) { return exact.velocity(y, t); };
  };

  State s = state_at_rest(setup);
  support::set_by_position(s.velocity.x, g, support::kFaceX, velocity_at(0));
  support::shear_material(
      s.material, g, g.ny_fluid, [&](double y) { return exact.displacement(y, 0); },
      [&](double y) { return exact.shear(y, 0); });
  start(s, setup);
  const double end = (std::numbers::pi + 0.8) / l.w;
  SolidInput input = setup.solid->input(s.material);
  input.ratio_across = input.viscosity_ratio;  // dt ~ dy^2, though an implicit viscosity would not need it
  const double limit =
      std::min(fluid::viscosity_limit(setup.viscosity, input, g), 0.3 / std::sqrt(l.G) * g.dy[0]);
  const int steps = static_cast<int>(std::ceil(end / (0.8 * limit)));
  const double dt = end / steps;
  for (int n = 0; n < steps; ++n) {
    // The wall keeps the velocity of the middle of the step, an error of order dt^2 (and dt ~ dy^2).
    setup.walls.bottom_u = std::sin(l.w * (n + 0.5) * dt);
    advance(s, setup, dt);
  }

  Errors errors;
  errors.velocity =
      support::largest_error(s.velocity.x, g, support::kFaceX, setup.decomposition, velocity_at(end));
  double amplitude = 0;
  for (int j = g.ny_fluid + 1; j < g.ny; ++j) {
    const double shear = exact.shear(g.y_face[j], end);
    amplitude = std::max(amplitude, std::abs(exact.shear_amplitude(g.y_face[j])));
    errors.shear = support::worse(errors.shear, std::abs(s.material.B.xy(0, j, 0) - shear));
    const double stretch = 1 + std::pow(exact.shear(g.y_center[j], end), 2);
    errors.stretch = support::worse(errors.stretch, std::abs(s.material.B.xx(0, j, 0) - stretch));
  }
  errors.shear /= amplitude;
  return errors;
}

class LayeredWall : public testing::TestWithParam<support::NamedSolid> {
 protected:
  static void expect_second_order(const Layers& layers) {
    std::vector<double> velocity, shear;
    Errors fine;
    for (const int cells : {16, 32, 64}) {
      fine = run(layers, GetParam().spec, cells);
      velocity.push_back(fine.velocity);
      shear.push_back(fine.shear);
    }
    const std::string name = std::string("layered oscillating wall, ") + layers.name;
    support::expect_order(name + ", u", velocity, 1.9);
    support::expect_order(name + ", B_xy", shear, 1.9);
    for (const double error : {fine.velocity, fine.shear, fine.stretch}) EXPECT_LT(error, 5e-3);
  }
};

TEST_P(LayeredWall, OfTheSameViscosityIsSecondOrder) {
  expect_second_order({"equal viscosities", 3.14159, 0.5, 0.5, 1, 1, 5});
}
TEST_P(LayeredWall, WithoutViscosityToo) {
  expect_second_order({"no solid viscosity", 3.14159, 0.5, 0.5, 1, 0, 5});
}
TEST_P(LayeredWall, OfTenTimesTheViscosityToo) {
  expect_second_order({"viscosity ratio 10", 3.14159, 0.5, 0.5, 0.1, 1, 1});
}

INSTANTIATE_TEST_SUITE_P(Solids, LayeredWall, testing::ValuesIn(support::solids()), support::solid_name);

}  // namespace
}  // namespace softwall::time
