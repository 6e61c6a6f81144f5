#include "solver/time/interface_wave.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "solver/case/interface_mode.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/time/initial.hpp"

namespace softwall::time {

namespace {

using Complex = InterfaceMode::Complex;

/// The mode at t = 0, above x = 0: derivatives of the given order in y of v and of the displacement xi_y.
class Wave {
 public:
  explicit Wave(const Physics& p)
      : mode_(layers_of(p), {-p.wave->decay, p.wave->frequency}),
        scale_(p.wave->displacement * mode_.rate() / mode_.v(kInterface)) {}

  [[nodiscard]] double v(double y, int order) const { return std::real(scale_ * mode_.v(y, order)); }

  [[nodiscard]] double xi(double y, int order) const {
    return std::real(scale_ * mode_.v(y, order) / mode_.rate());
  }

  /// xi of the solid, which goes on below the interface in a straight line.
  [[nodiscard]] double xi_of_solid(double y, int order) const {
    const double at = in_solid(y);
    return xi(at, order) + std::min(y - kInterface, 0.0) * xi(at, order + 1);
  }

  /// The nearest height that belongs to the solid.
  [[nodiscard]] static double in_solid(double y) {
    constexpr double kJustAbove = 1e-12;  // of two values that meet at the interface, the solid's
    return std::max(y, kInterface + kJustAbove);
  }

  static constexpr double kInterface = 2;

 private:
  static WaveLayers layers_of(const Physics& p) {
    return wave_layers(p.reynolds, p.length_x, p.layer_height, p.solid->G, p.solid->viscosity_ratio);
  }

  InterfaceMode mode_;
  Complex scale_;
};

/// sin(k x) on the low-x faces and cos(k x) at the centers of this rank's columns.
struct Columns {
  std::vector<double> sin_face, cos_center;
  double k;

  explicit Columns(const grid::Grid& g) : k(2 * std::numbers::pi / g.length_x) {
    for (int i = 0; i < g.nx; ++i) {
      sin_face.push_back(std::sin(k * (g.x_begin + i) * g.dx));
      cos_center.push_back(std::cos(k * (g.x_begin + i + 0.5) * g.dx));
    }
  }
};

/// field(i, j, k) = amplitude(y) shape[i] in rows [row, rows), y from the array given.
template <class Amplitude>
void fill(grid::Field& field, const grid::Grid& g, grid::RowSpan rows, const grid::RowArray& y,
          const std::vector<double>& shape, const Amplitude& amplitude) {
  const auto q = field.view();
  for (int j = rows.j0; j < rows.j1; ++j) {
    const double a = amplitude(y[j]);
    for (int k = 0; k < g.nz; ++k) {
      for (int i = 0; i < g.nx; ++i) q(i, j, k) = grid::Real(a * shape[static_cast<std::size_t>(i)]);
    }
  }
}

void set_velocity(const Wave& wave, const Columns& at, const grid::Grid& g, grid::VectorField& velocity) {
  fill(velocity.x, g, {0, g.ny}, g.y_center, at.sin_face, [&](double y) { return -wave.v(y, 1) / at.k; });
  fill(velocity.y, g, {0, g.ny + 1}, g.y_face, at.cos_center, [&](double y) { return wave.v(y, 0); });
}

void set_displacement(const Wave& wave, const Columns& at, const grid::Grid& g, grid::VectorField& d) {
  fill(d.x, g, {0, g.ny}, g.y_center, at.sin_face, [&](double y) { return -wave.xi_of_solid(y, 1) / at.k; });
  fill(d.y, g, {0, g.ny + 1}, g.y_face, at.cos_center, [&](double y) { return wave.xi_of_solid(y, 0); });
}

/// phi: the share of each cell above the interface. B - I = grad(xi) + grad(xi)^T:
///   B_xy = -(xi_y'' / k + k xi_y) sin(k x),   B_yy - 1 = 1 - B_xx = 2 xi_y' cos(k x).
void set_solid(const Wave& wave, const Columns& at, const grid::Grid& g, solid::Material& m) {
  const auto phi = m.phi.view(), xx = m.B.xx.view(), yy = m.B.yy.view();
  const double crest = wave.xi_of_solid(Wave::kInterface, 0);
  fill(m.B.xy, g, {g.ny_fluid, g.ny + 1}, g.y_face, at.sin_face, [&](double y) {
    return -(wave.xi(Wave::in_solid(y), 2) / at.k + at.k * wave.xi(Wave::in_solid(y), 0));
  });
  for (int j = 0; j < g.ny; ++j) {
    const double stretch = j < g.ny_fluid ? 0 : 2 * wave.xi(g.y_center[j], 1);
    for (int k = 0; k < g.nz; ++k) {
      for (int i = 0; i < g.nx; ++i) {
        const double shape = at.cos_center[static_cast<std::size_t>(i)];
        const double surface = Wave::kInterface + crest * shape;
        phi(i, j, k) = grid::Real(std::clamp((g.y_face[j + 1] - surface) / g.dy[j], 0.0, 1.0));
        if (j < g.ny_fluid) continue;
        xx(i, j, k) = grid::Real(1 - stretch * shape);
        yy(i, j, k) = grid::Real(1 + stretch * shape);
      }
    }
  }
}

}  // namespace

State interface_wave_at_start(Setup& setup) {
  const auto& g = setup.grid;
  const Wave wave(setup.physics);
  const Columns at(g);
  State s = state_at_rest(setup);
  set_velocity(wave, at, g, s.velocity);
  if (s.material.formulation == SolidFormulation::kReferenceMap) {
    set_displacement(wave, at, g, s.material.displacement);
  } else {
    set_solid(wave, at, g, s.material);
  }
  make_solenoidal(s, setup);
  return s;
}

}  // namespace softwall::time
