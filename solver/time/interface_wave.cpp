#include "solver/time/interface_wave.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "solver/case/interface_mode.hpp"
#include "solver/case/wall_normal_grid.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/time/initial.hpp"
#include "solver/time/laminar_mean.hpp"

namespace softwall::time {

namespace {

using Complex = InterfaceMode::Complex;

/// What the wave is at a height, above x = 0 and above a quarter of a wave further on: the real part goes
/// with cos(k x), the imaginary part with sin(k x), of v and of the displacement xi along y. Over fluid at
/// rest the wave stands, and the imaginary part is zero. Over a mean flow U it is Re[(a + i b) exp(-i k x)],
/// which moves downstream since the rate is taken with a positive frequency; U follows its displacement: v -
/// i k U xi.
class Wave {
 public:
  explicit Wave(const Physics& p)
      : mode_(layers_of(p), {-p.wave->decay, p.wave->frequency}),
        scale_(p.wave->displacement * mode_.rate() / mode_.v(kFluidHeight)),
        moves_(p.wave->mean_flow != MeanFlow::kNone),
        k_(2 * std::numbers::pi / p.length_x) {}

  /// v, or its derivative (order 1).
  [[nodiscard]] Complex v(double y, int order) const {
    if (!moves_) return std::real(scale_ * mode_.v(y, order));
    const Complex follows = order == 0 ? U(y) * xi(y, 0) : U(y) * xi(y, 1) + U_slope(y) * xi(y, 0);
    return scale_ * mode_.v(y, order) - Complex(0, k_) * follows;
  }

  [[nodiscard]] Complex xi(double y, int order) const {
    const Complex value = scale_ * mode_.v(y, order) / mode_.rate();
    return moves_ ? value : std::real(value);
  }

  /// xi of the solid, which goes on below the interface in a straight line.
  [[nodiscard]] Complex xi_of_solid(double y, int order) const {
    const double at = in_solid(y);
    return xi(at, order) + std::min(y - kFluidHeight, 0.0) * xi(at, order + 1);
  }

  /// The nearest height that belongs to the solid.
  [[nodiscard]] static double in_solid(double y) {
    constexpr double kJustAbove = 1e-12;  // of two values that meet at the interface, the solid's
    return std::max(y, kFluidHeight + kJustAbove);
  }

 private:
  static double U(double y) { return y < kFluidHeight ? 1.5 * y * (kFluidHeight - y) : 0; }
  static double U_slope(double y) { return y < kFluidHeight ? 3 * (1 - y) : 0; }

  static WaveLayers layers_of(const Physics& p) {
    return wave_layers(p.reynolds, p.length_x, p.layer_height, p.solid->G, p.solid->viscosity_ratio);
  }

  InterfaceMode mode_;
  Complex scale_;
  bool moves_;
  double k_;
};

/// cos(k x) and sin(k x) over this rank's columns, along a row of centers or of low-x faces.
struct Shape {
  std::vector<double> cos, sin;
  Shape(const grid::Grid& g, double offset) {
    for (int i = 0; i < g.nx; ++i) {
      const double angle = 2 * std::numbers::pi / g.length_x * ((g.x_begin + i + offset) * g.dx);
      cos.push_back(std::cos(angle));
      sin.push_back(std::sin(angle));
    }
  }
  [[nodiscard]] double upright(Complex a, std::size_t i) const {
    return a.real() * cos[i] + a.imag() * sin[i];
  }
  [[nodiscard]] double along(Complex a, std::size_t i) const { return a.imag() * cos[i] - a.real() * sin[i]; }
};

struct Columns {
  Shape face, center;
  double k;
  explicit Columns(const grid::Grid& g) : face(g, 0), center(g, 0.5), k(2 * std::numbers::pi / g.length_x) {}
};

/// field(i, j, k) = value(j, i) in rows.
template <class Value>
void fill(grid::Field& field, const grid::Grid& g, grid::RowSpan rows, const Value& value) {
  const auto q = field.view();
  for (int j = rows.j0; j < rows.j1; ++j) {
    const auto in_row = value(j);
    for (int k = 0; k < g.nz; ++k) {
      for (int i = 0; i < g.nx; ++i) q(i, j, k) = grid::Real(in_row(static_cast<std::size_t>(i)));
    }
  }
}

/// What stands on y faces goes as `upright`, with a(y); on x faces as `along`, with a'(y) / k; `mean(j)` is
/// added along x.
template <class Amplitude, class Mean>
void set_vector(grid::VectorField& field, const grid::Grid& g, const Columns& at, const Amplitude& amplitude,
                const Mean& mean) {
  fill(field.x, g, {0, g.ny}, [&](int j) {
    return [&at, a = amplitude(g.y_center[j], 1) / at.k, m = mean(j)](std::size_t i) {
      return m + at.face.along(a, i);
    };
  });
  fill(field.y, g, {0, g.ny + 1}, [&](int j) {
    return [&at, a = amplitude(g.y_face[j], 0)](std::size_t i) { return at.center.upright(a, i); };
  });
}

/// What the mean flow has made of the layer, where there is one.
struct MeanShear {
  const LaminarMean* mean;
  [[nodiscard]] double gamma(double y) const { return mean ? mean->shear(y) : 0; }
};

/// phi: the share of each cell above the interface. To first order in the wave and without products of it and
/// the shear gamma of the mean flow,
///   B_xy = gamma + d(xi_x)/dy + d(xi_y)/dx,   B_yy = 1 + 2 xi_y',   B_xx = 1 + gamma^2 - 2 xi_y'.
void set_solid(const Wave& wave, const MeanShear& shear, const Columns& at, const grid::Grid& g,
               solid::Material& m) {
  fill(m.B.xy, g, {g.ny_fluid, g.ny + 1}, [&](int j) {
    const double y = Wave::in_solid(g.y_face[j]);
    return [&at, gamma = shear.gamma(y), a = wave.xi(y, 2) / at.k + at.k * wave.xi(y, 0)](std::size_t i) {
      return gamma + at.face.along(a, i);
    };
  });
  const auto stretch = [&](int j, double unstretched, double sign) {
    return [&at, unstretched, a = sign * 2 * wave.xi(g.y_center[j], 1)](std::size_t i) {
      return unstretched + at.center.upright(a, i);
    };
  };
  const auto gamma_at = [&](int j) { return shear.gamma(g.y_center[j]); };
  fill(m.B.xx, g, {g.ny_fluid, g.ny}, [&](int j) { return stretch(j, 1 + gamma_at(j) * gamma_at(j), -1); });
  fill(m.B.yy, g, {g.ny_fluid, g.ny}, [&](int j) { return stretch(j, 1, 1); });
  fill(m.phi, g, {0, g.ny}, [&](int j) {
    return [&, j, crest = wave.xi_of_solid(kFluidHeight, 0)](std::size_t i) {
      const double surface = kFluidHeight + at.center.upright(crest, i);
      return std::clamp((g.y_face[j + 1] - surface) / g.dy[j], 0.0, 1.0);
    };
  });
}

}  // namespace

State interface_wave_at_start(Setup& setup) {
  const auto& g = setup.grid;
  const Wave wave(setup.physics);
  const Columns at(g);
  std::optional<LaminarMean> mean;
  if (setup.bulk_velocity) mean.emplace(setup);
  State s = state_at_rest(setup);
  set_vector(
      s.velocity, g, at, [&](double y, int order) { return wave.v(y, order); },
      [&](int j) { return mean ? mean->u(j) : 0; });
  if (s.material.formulation == SolidFormulation::kReferenceMap) {
    set_vector(
        s.material.displacement, g, at, [&](double y, int order) { return wave.xi_of_solid(y, order); },
        [&](int j) { return mean ? mean->displacement(j) : 0; });
  } else {
    set_solid(wave, {mean ? &*mean : nullptr}, at, g, s.material);
  }
  if (mean) s.driving_gradient = mean->gradient();
  make_solenoidal(s, setup);
  return s;
}

}  // namespace softwall::time
