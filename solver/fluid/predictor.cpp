#include "solver/fluid/predictor.hpp"

#include <algorithm>
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

/// What acts on a row of cells beside the fluid's own stresses.
enum class Holds { kFluid, kSolid, kSolidWithExcessViscosity };

/// A component of the forces of the solid; `viscous` over the viscosity of the fluid.
struct Forces {
  View<const Real> elastic, elastic_before, viscous;
  Real viscosity;
};

/// One row of one component.
template <Holds kHolds, class PressureGradient>
void update(int nx, int j, int k, const Weights& w, const Real* fluid, View<const Real> old,
            const Forces& forces, const Output& out, const PressureGradient& gradient) {
#pragma omp simd
  for (int i = 0; i < nx; ++i) {
    Real now = fluid[i];
    if constexpr (kHolds == Holds::kSolidWithExcessViscosity)
      now += forces.viscosity * forces.viscous(i, j, k);
    Real change = w.now * now + w.before * out.rate(i, j, k) - w.pressure * gradient(i, j, k);
    if constexpr (kHolds != Holds::kFluid) {
      change += w.force * (forces.elastic(i, j, k) + forces.elastic_before(i, j, k));
    }
    out.rate(i, j, k) = now;
    out.predicted(i, j, k) = old(i, j, k) + change;
  }
}

/// The three components in rows j0 <= j < j1 (v: without the wall row 0).
template <Holds kHolds>
void predict_rows(MomentumSweep& sweep, int nx, int j0, int j1, const MomentumInput& m, View<const Real> p,
                  const Weights& w, const SolidInput& solid, grid::VectorField& rate,
                  grid::VectorField& predicted) {
  const auto forces = [&](grid::Field grid::VectorField::*component, View<const Real> unused) -> Forces {
    const auto view = [=](const grid::VectorField* f) { return f ? (f->*component).view() : unused; };
    return {view(solid.force_now), view(solid.force_before), view(solid.excess_viscous), m.nu};
  };
  const Forces on_x = forces(&grid::VectorField::x, m.u), on_y = forces(&grid::VectorField::y, m.v),
               on_z = forces(&grid::VectorField::z, m.w);
  const Output x{rate.x.view(), predicted.x.view()}, y{rate.y.view(), predicted.y.view()},
      z{rate.z.view(), predicted.z.view()};
  sweep.for_each_row(m, j0, j1, [&](int row, int plane, const MomentumRow& fluid) {
    update<kHolds>(nx, row, plane, w, fluid.x, m.u, on_x, x,
                   [=](int i, int j, int k) { return (p(i, j, k) - p(i - 1, j, k)) * m.inv_dx; });
    if (row > 0) {
      update<kHolds>(nx, row, plane, w, fluid.y, m.v, on_y, y,
                     [=](int i, int j, int k) { return (p(i, j, k) - p(i, j - 1, k)) * m.inv_dy_face[j]; });
    }
    update<kHolds>(nx, row, plane, w, fluid.z, m.w, on_z, z,
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
  const MomentumInput m{old.x.view(),    old.y.view(),         old.z.view(),
                        g.inv_dy.data(), g.inv_dy_face.data(), g.upper_share.data(),
                        Real(1 / g.dx),  Real(1 / g.dz),       Real(viscosity_)};
  const Weights w{Real(2 * stage.alpha * dt), Real(stage.alpha * dt), Real(stage.beta * dt),
                  Real(stage.gamma * dt)};
  const auto p = pressure.view();
  const int solid_row = solid.force_now ? solid.first_row : g.ny;
  const int plain_row = solid.excess_viscous ? std::max(solid_row, solid.excess_end_row) : solid_row;
  predict_rows<Holds::kFluid>(sweep_, g.nx, 0, solid_row, m, p, w, solid, rate_, predicted_);
  predict_rows<Holds::kSolidWithExcessViscosity>(sweep_, g.nx, solid_row, plain_row, m, p, w, solid, rate_,
                                                 predicted_);
  predict_rows<Holds::kSolid>(sweep_, g.nx, plain_row, g.ny, m, p, w, solid, rate_, predicted_);
  std::swap(velocity, predicted_);
}

}  // namespace softwall::fluid
