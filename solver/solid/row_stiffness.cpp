#include "solver/solid/row_stiffness.hpp"

#include <algorithm>
#include <utility>

#include "solver/solid/fraction.hpp"

namespace softwall::solid {

/// c where rows meet, over the height between them.
struct RowStiffness::Edges {
  Fraction phi;
  View<const Real> Byy;
  InterfaceShareView share;
  const Real *inv_dy, *inv_dy_face;
  Real elastic, viscous;  ///< weights
  Real ratio;             ///< of the viscosities
  int top;                ///< the edge on the upper wall
  int solid_from;         ///< edges of this row and of those above lie in the solid altogether

  template <class InPlane>
  [[nodiscard]] Real between(int j, const InPlane& q) const {
    const Real below = q(j - 1), upper_share = j == 0 ? 1 : j == top ? 0 : phi.upper_share[j];
    return below + upper_share * (q(j) - below);
  }
  [[nodiscard]] Real Byy_xy(int i, int j, int k) const {
    return between(j, [=, this](int row) { return Byy(i, row, k) + Byy(i - 1, row, k); }) / 2;
  }
  [[nodiscard]] Real Byy_yz(int i, int j, int k) const {
    return between(j, [=, this](int row) { return Byy(i, row, k) + Byy(i, row, k - 1); }) / 2;
  }
  template <bool kViscous>
  [[nodiscard]] Real in_solid(int j, Real stretch) const {
    Real c = elastic * stretch;
    if constexpr (kViscous) c += viscous * (ratio - 1);
    return c * inv_dy_face[j];
  }
  /// On an edge of which the share `fraction` is solid; a: of interface_share.hpp. What the solid's own shear
  /// does there counts as if it were that of the edge.
  template <bool kViscous>
  [[nodiscard]] Real shared(int j, Real fraction, Real a, Real stretch) const {
    const Real s = share_of_solid(fraction, a);
    Real c = elastic * s * stretch;
    if constexpr (kViscous) {
      const Real fluid = factor_of_fluid(fraction, a);
      c += viscous * (fluid - 1 + std::max(Real(0), ratio * s - fluid * fraction));
    }
    return c * inv_dy_face[j];
  }
  template <bool kViscous>
  [[nodiscard]] Real center(int i, int j, int k) const {
    Real c = elastic * Byy(i, j, k);
    if constexpr (kViscous) c += 2 * viscous * (ratio - 1);
    return c * phi.center(i, j, k) * inv_dy[j];
  }
};

namespace {

template <class Value>
void fill(Real* row, int n, const Value& value) {
#pragma omp simd
  for (int i = 0; i < n; ++i) row[i] = value(i);
}

}  // namespace

RowStiffness::RowStiffness(const SolidSpec& spec, const InterfaceShare& share, const Grid& g)
    : G_(spec.G),
      viscosity_ratio_(spec.viscosity_ratio),
      share_(share),
      grid_(g),
      stride_(parallel::whole_lines<Real>(g.nx)) {
  const auto length = static_cast<std::size_t>(stride_);
  for (Row* one : {&low_, &high_, &rest_}) one->resize(length);
  for (Row* plane : {&change_, &ratio_}) plane->resize(length * static_cast<std::size_t>(g.ny));
}

void RowStiffness::apply(const Material& m, const grid::VectorField& before, const ImplicitWeights& weights,
                         int first_row, grid::VectorField& velocity) {
  const Grid& g = grid_;
  const Edges edges{{m.phi.view(), g.upper_share.data()},
                    m.B.yy.view(),
                    share_.view(),
                    g.inv_dy.data(),
                    g.inv_dy_face.data(),
                    Real((1 + kSpare) * G_ * weights.dt * weights.dt / 4),
                    Real(weights.viscous),
                    Real(viscosity_ratio_),
                    g.ny,
                    std::max(first_row, m.solid_edges_from(g.ny))};
  if (viscosity_ratio_ > 1) {
    apply<true>(edges, before, first_row, velocity);
  } else {
    apply<false>(edges, before, first_row, velocity);
  }
}

template <bool kViscous>
void RowStiffness::apply(const Edges& at, const grid::VectorField& before, int first_row,
                         grid::VectorField& velocity) {
  const Grid& g = grid_;
  const int ny = g.ny, nx = g.nx;
  // On a wall the material holds fast, half a height away from the row beside it; below the band there is
  // none.
  const auto at_ends = [=](Real* row, int j) {
    const Real factor = j == 0 || j == ny ? 2 : j == first_row ? 0 : 1;
    if (factor != 1) fill(row, nx, [=](int i) { return factor * row[i]; });
  };
  for (int k = 0; k < g.nz; ++k) {
    const auto on_xy = [=](Real* row, int j) {
      if (j < at.solid_from) {
        fill(row, nx, [=](int i) {
          return at.template shared<kViscous>(j, at.phi.edge_xy(i, j, k), at.share.xy(i, k),
                                              at.Byy_xy(i, j, k));
        });
      } else {
        fill(row, nx, [=](int i) { return at.template in_solid<kViscous>(j, at.Byy_xy(i, j, k)); });
      }
      at_ends(row, j);
    };
    const auto on_yz = [=](Real* row, int j) {
      if (j < at.solid_from) {
        fill(row, nx, [=](int i) {
          return at.template shared<kViscous>(j, at.phi.edge_yz(i, j, k), at.share.yz(i, k),
                                              at.Byy_yz(i, j, k));
        });
      } else {
        fill(row, nx, [=](int i) { return at.template in_solid<kViscous>(j, at.Byy_yz(i, j, k)); });
      }
      at_ends(row, j);
    };
    const auto on_centers = [=](Real* row, int j) {
      const bool in_band = j > first_row;
      fill(row, nx, [=](int i) { return in_band ? at.template center<kViscous>(i, j - 1, k) : 0; });
    };
    solve(first_row, g.inv_dy.data(), on_xy, before.x.view(), velocity.x.view(), k);
    solve(std::max(first_row, 1), g.inv_dy_face.data(), on_centers, before.y.view(), velocity.y.view(), k);
    solve(first_row, g.inv_dy.data(), on_yz, before.z.view(), velocity.z.view(), k);
  }
}

/// Thomas algorithm for the columns of a plane side by side, in the form of pressure/tridiagonal.cpp, which
/// is free of cancellation. c(row, j) fills the coefficients below the unknowns of row j; beyond both ends
/// q = 0.
template <class Coefficient>
void RowStiffness::solve(int row0, const Real* inverse_height, const Coefficient& c, View<const Real> before,
                         View<Real> velocity, int k) {
  const int nx = grid_.nx, ny = grid_.ny;
  Real* const rest = rest_.data();
  std::fill(rest, rest + nx, Real(1));
  c(low_.data(), row0);
  for (int j = row0; j < ny; ++j) {
    c(high_.data(), j + 1);
    const Real factor = inverse_height[j];
    const Real *const low = low_.data(), *const high = high_.data();
    Real *const q = row(change_, j), *const f = row(ratio_, j);
    const Real* const below = j > row0 ? row(change_, j - 1) : nullptr;
    const Real *const old = &before(0, j, k), *const now = &velocity(0, j, k);
    const auto eliminate = [=](const auto& from_below) {
#pragma omp simd
      for (int i = 0; i < nx; ++i) {
        const Real lower = factor * low[i], upper = factor * high[i], here = 1 + lower * rest[i];
        const Real inverse = 1 / (here + upper);
        rest[i] = here * inverse;
        f[i] = upper * inverse;
        q[i] = (now[i] - old[i] + lower * from_below(i)) * inverse;
      }
    };
    if (below) {
      eliminate([=](int i) { return below[i]; });
    } else {
      eliminate([](int) { return Real(0); });
    }
    std::swap(low_, high_);
  }
  for (int j = ny - 1; j >= row0; --j) {
    Real* const q = row(change_, j);
    const Real *const f = row(ratio_, j), *const old = &before(0, j, k);
    Real* const now = &velocity(0, j, k);
    if (j < ny - 1) {
      const Real* const above = row(change_, j + 1);
#pragma omp simd
      for (int i = 0; i < nx; ++i) q[i] += f[i] * above[i];
    }
#pragma omp simd
    for (int i = 0; i < nx; ++i) now[i] = old[i] + q[i];
  }
}

}  // namespace softwall::solid
