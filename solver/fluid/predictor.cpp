#include "solver/fluid/predictor.hpp"

#include <utility>

namespace softwall::fluid {

namespace {

/// The numbers of a substep, premultiplied by dt.
struct Weights {
  Real pressure, force, now, before;
};

struct Output {
  View<Real> rate, predicted;
};

/// One row of one component; kForce: it holds solid.
template <bool kForce, class PressureGradient>
void update(int nx, int j, int k, const Weights& w, const Real* now, View<const Real> old,
            View<const Real> force, const Output& out, const PressureGradient& gradient) {
#pragma omp simd
  for (int i = 0; i < nx; ++i) {
    Real change = w.now * now[i] + w.before * out.rate(i, j, k) - w.pressure * gradient(i, j, k);
    if constexpr (kForce) change += w.force * force(i, j, k);
    out.rate(i, j, k) = now[i];
    out.predicted(i, j, k) = old(i, j, k) + change;
  }
}

/// The three components in rows j0 <= j < j1 (v: without the wall row 0).
template <bool kVariable, bool kForce>
void predict_rows(MomentumSweep& sweep, int nx, int j0, int j1, const MomentumInput& m, View<const Real> p,
                  const Weights& w, const grid::VectorField* force, grid::VectorField& rate,
                  grid::VectorField& predicted) {
  const auto view = [](const grid::Field& f) { return f.view(); };
  const auto force_x = force ? view(force->x) : m.u, force_y = force ? view(force->y) : m.v,
             force_z = force ? view(force->z) : m.w;
  const Output x{rate.x.view(), predicted.x.view()}, y{rate.y.view(), predicted.y.view()},
      z{rate.z.view(), predicted.z.view()};
  sweep.for_each_row<kVariable>(m, j0, j1, [&](int row, int plane, const MomentumRow& now) {
    update<kForce>(nx, row, plane, w, now.x, m.u, force_x, x,
                   [=](int i, int j, int k) { return (p(i, j, k) - p(i - 1, j, k)) * m.inv_dx; });
    if (row > 0) {
      update<kForce>(nx, row, plane, w, now.y, m.v, force_y, y,
                     [=](int i, int j, int k) { return (p(i, j, k) - p(i, j - 1, k)) * m.inv_dy_face[j]; });
    }
    update<kForce>(nx, row, plane, w, now.z, m.w, force_z, z,
                   [=](int i, int j, int k) { return (p(i, j, k) - p(i, j, k - 1)) * m.inv_dz; });
  });
}

}  // namespace

Predictor::Predictor(const Grid& grid, double viscosity)
    : grid_(grid),
      viscosity_(viscosity),
      sweep_(grid),
      rate_(grid, 1, grid::Memory::kWhole),
      predicted_(grid, 1, grid::Memory::kWhole) {}

void Predictor::advance(grid::VectorField& velocity, const grid::Field& pressure, const SolidInput& solid,
                        const Stage& stage, double dt) {
  const auto& g = grid_;
  const auto& old = std::as_const(velocity);
  MomentumInput m{old.x.view(),
                  old.y.view(),
                  old.z.view(),
                  old.x.view(),
                  g.inv_dy.data(),
                  g.inv_dy_face.data(),
                  g.upper_share.data(),
                  Real(1 / g.dx),
                  Real(1 / g.dz),
                  Real(viscosity_),
                  Real(viscosity_ * (solid.viscosity_ratio - 1))};
  const Weights w{Real(2 * stage.alpha * dt), Real(stage.alpha * dt), Real(stage.beta * dt),
                  Real(stage.gamma * dt)};
  const auto p = pressure.view();
  const int solid_row = solid.force ? solid.first_row : g.ny;
  predict_rows<false, false>(sweep_, g.nx, 0, solid_row, m, p, w, nullptr, rate_, predicted_);
  if (solid_row < g.ny) {
    m.phi = solid.fraction->view();
    if (solid.viscosity_ratio == 1) {
      predict_rows<false, true>(sweep_, g.nx, solid_row, g.ny, m, p, w, solid.force, rate_, predicted_);
    } else {
      predict_rows<true, true>(sweep_, g.nx, solid_row, g.ny, m, p, w, solid.force, rate_, predicted_);
    }
  }
  std::swap(velocity, predicted_);
}

}  // namespace softwall::fluid
