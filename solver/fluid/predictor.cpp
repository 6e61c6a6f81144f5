#include "solver/fluid/predictor.hpp"

#include <algorithm>
#include <utility>

namespace softwall::fluid {

namespace {

/// The numbers of a substep, premultiplied by dt.
struct Weights {
  Real pressure, force, now, before;
};

/// What acts on a row of cells beside the fluid's own stresses.
enum class Holds { kFluid, kSolid, kSolidWithExcessViscosity, kSolidWithViscosityAcross };

/// A component of the velocity before and after, its rate, and the forces of the solid; `viscous` over the
/// viscosity of the fluid. Forces that are not there are not read.
struct Component {
  View<const Real> old;
  View<Real> rate, predicted;
  View<const Real> elastic, elastic_before, viscous, across;
};

/// What a substep does to a row of cells.
struct RowUpdate {
  MomentumInput m;
  View<const Real> p;
  Weights w;
  Component x, y, z;
  int nx;

  /// The three components (v: without the wall row 0).
  template <Holds kHolds>
  void run(int row, int plane, const MomentumRow& fluid) const {
    const auto pressure = p;
    const Real inv_dx = m.inv_dx, inv_dy = m.inv_dy_face[row], inv_dz = m.inv_dz;
    update<kHolds>(row, plane, fluid.x, x,
                   [=](int i, int j, int k) { return (pressure(i, j, k) - pressure(i - 1, j, k)) * inv_dx; });
    if (row > 0) {
      update<kHolds>(row, plane, fluid.y, y, [=](int i, int j, int k) {
        return (pressure(i, j, k) - pressure(i, j - 1, k)) * inv_dy;
      });
    }
    update<kHolds>(row, plane, fluid.z, z,
                   [=](int i, int j, int k) { return (pressure(i, j, k) - pressure(i, j, k - 1)) * inv_dz; });
  }

 private:
  template <Holds kHolds, class PressureGradient>
  void update(int j, int k, const Real* fluid, const Component& component,
              const PressureGradient& gradient) const {
    // Copies, which what the loop writes cannot change: the compiler need not read them again.
    const Component c = component;
    const Weights weights = w;
    const Real viscosity = m.nu;
    const int n = nx;
#pragma omp simd
    for (int i = 0; i < n; ++i) {
      Real now = fluid[i];
      if constexpr (kHolds >= Holds::kSolidWithExcessViscosity) now += viscosity * c.viscous(i, j, k);
      Real change =
          weights.now * now + weights.before * c.rate(i, j, k) - weights.pressure * gradient(i, j, k);
      if constexpr (kHolds != Holds::kFluid) {
        change += weights.force * (c.elastic(i, j, k) + c.elastic_before(i, j, k));
      }
      if constexpr (kHolds == Holds::kSolidWithViscosityAcross) {
        change += 2 * weights.force * viscosity * c.across(i, j, k);
      }
      c.rate(i, j, k) = now;
      c.predicted(i, j, k) = c.old(i, j, k) + change;
    }
  }
};

}  // namespace

Predictor::Predictor(const Grid& grid, double viscosity)
    : grid_(grid),
      viscosity_(viscosity),
      sweep_(grid),
      rate_(grid, 1, grid::Memory::kByPlane),
      predicted_(grid, 1, grid::Memory::kByPlane) {}

void Predictor::advance(grid::VectorField& velocity, const grid::Field& pressure, const SolidInput& solid,
                        const Stage& stage, double dt) {
  const auto& g = grid_;
  const auto& old = std::as_const(velocity);
  const MomentumInput m = momentum_input(old, g, viscosity_);
  const Weights w{.pressure = Real(2 * stage.alpha * dt),
                  .force = Real(stage.alpha * dt),
                  .now = Real(stage.beta * dt),
                  .before = Real(stage.gamma * dt)};
  const auto component = [&](grid::Field grid::VectorField::*c) -> Component {
    const View<const Real> before = (old.*c).view();
    const auto view = [=](const grid::VectorField* force) { return force ? (force->*c).view() : before; };
    return {.old = before,
            .rate = (rate_.*c).view(),
            .predicted = (predicted_.*c).view(),
            .elastic = view(solid.force_now),
            .elastic_before = view(solid.force_before),
            .viscous = view(solid.excess_viscous),
            .across = view(solid.excess_across)};
  };
  const RowUpdate update{.m = m,
                         .p = pressure.view(),
                         .w = w,
                         .x = component(&grid::VectorField::x),
                         .y = component(&grid::VectorField::y),
                         .z = component(&grid::VectorField::z),
                         .nx = g.nx};
  const int solid_row = solid.force_now ? solid.first_row : g.ny;
  const int plain_row = solid.excess_viscous ? std::max(solid_row, solid.excess_end_row) : solid_row;
  sweep_.for_each_row(m, 0, g.ny, [&](int j, int k, const MomentumRow& fluid) {
    if (j < solid_row) {
      update.run<Holds::kFluid>(j, k, fluid);
    } else if (j < plain_row && solid.excess_across) {
      update.run<Holds::kSolidWithViscosityAcross>(j, k, fluid);
    } else if (j < plain_row) {
      update.run<Holds::kSolidWithExcessViscosity>(j, k, fluid);
    } else {
      update.run<Holds::kSolid>(j, k, fluid);
    }
  });
  std::swap(velocity, predicted_);
}

}  // namespace softwall::fluid
