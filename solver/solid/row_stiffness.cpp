#include "solver/solid/row_stiffness.hpp"

#include <algorithm>
#include <utility>

#include "solver/case/step_limits.hpp"
#include "solver/solid/row_coefficients.hpp"

namespace softwall::solid {

namespace {

template <class Value>
void fill(Real* row, int n, const Value& value) {
#pragma omp simd
  for (int i = 0; i < n; ++i) row[i] = value(i);
}

}  // namespace

RowStiffness::RowStiffness(const SolidSpec& spec, const Formulation& formulation, const Grid& g)
    : law_(law_of<double>(spec)),
      viscosity_ratio_(spec.viscosity_ratio),
      formulation_(formulation),
      grid_(g),
      stride_(parallel::whole_lines<Real>(g.nx)) {
  const auto length = static_cast<std::size_t>(stride_);
  for (Row* one : {&low_.own, &low_.above, &high_.own, &high_.above, &rest_}) one->resize(length);
  for (Row* plane : {&change_, &ratio_, &second_ratio_})
    plane->resize(length * static_cast<std::size_t>(g.ny + 1));
}

void RowStiffness::apply(const Material& m, const grid::VectorField& before, const ImplicitWeights& weights,
                         int first_row, grid::VectorField& velocity) {
  const Grid& g = grid_;
  const InterfaceShare& share = formulation_.interface_share();
  const RowCoefficients edges{
      .phi = fraction_of(m, share, g),
      .Byy = m.B.yy.view(),
      .C = cofactors_of(m, g),
      .law = {Real(law_.G), Real(law_.mooney_share)},
      .share = share.view(),
      .inv_dy = g.inv_dy.data(),
      .inv_dy_face = g.inv_dy_face.data(),
      .elastic = Real((1 + step_limits::kSpareStiffness) * law_.stiffness(1) * weights.dt * weights.dt / 4),
      .viscous = Real(weights.viscous),
      .ratio = Real(viscosity_ratio_),
      .solid_edge = formulation_.solid_from(),
      .top = g.ny,
      .solid_from = std::max(first_row, m.solid_edges_from(g.ny))};
  const auto driving = Real(weights.driving);
  if (viscosity_ratio_ > 1) {
    apply<true>(edges, before, driving, first_row, velocity);
  } else {
    apply<false>(edges, before, driving, first_row, velocity);
  }
}

template <bool kViscous>
void RowStiffness::apply(const RowCoefficients& edges, const grid::VectorField& before, Real driving,
                         int first_row, grid::VectorField& velocity) {
  if (law_.is_neo_hookean()) {
    apply_law<kViscous, true>(edges, before, driving, first_row, velocity);
  } else {
    apply_law<kViscous, false>(edges, before, driving, first_row, velocity);
  }
}

/// Coefficients on the edges of row j of a plane; fraction(i, j), a(i), stretch(i, j): of these edges.
template <bool kViscous, class FractionAt, class ShareAt, class StretchAt>
void RowStiffness::fill_edges(const RowCoefficients& at, int j, const FractionAt& fraction, const ShareAt& a,
                              const StretchAt& stretch, Side& side) const {
  const int nx = grid_.nx;
  Real *const own = side.own.data(), *const above = side.above.data();
  if (j < at.solid_from) {
    fill(own, nx,
         [=](int i) { return at.template shared<kViscous>(j, fraction(i, j), a(i), stretch(i, j)); });
    if constexpr (kViscous) fill(above, nx, [=](int i) { return at.shared_above(j, fraction(i, j), a(i)); });
  } else {
    fill(own, nx, [=](int i) { return at.template in_solid<kViscous>(j, stretch(i, j)); });
    if constexpr (kViscous) fill(above, nx, [](int) { return Real(0); });
  }
}

template <bool kViscous, bool kNeoHookean>
void RowStiffness::apply_law(const RowCoefficients& at, const grid::VectorField& before, Real driving,
                             int first_row, grid::VectorField& velocity) {
  const Grid& g = grid_;
  const int ny = g.ny, nx = g.nx;
  const auto on_edges = [=, this](const auto& fraction, const auto& a, const auto& stretch) {
    return [=, this](Side& side, int j) {
      fill_edges<kViscous>(at, j, fraction, a, stretch, side);
      Real *const own = side.own.data(), *const above = side.above.data();
      // On a wall the material holds fast, half a height from the row beside it; below the band there is
      // none.
      const Real factor = j == 0 || j == ny ? 2 : j == first_row ? 0 : 1;
      if (factor == 1) return;
      fill(own, nx, [=](int i) { return factor * own[i]; });
      if constexpr (kViscous) fill(above, nx, [](int) { return Real(0); });
    };
  };
  for (int k = 0; k < g.nz; ++k) {
    const auto on_xy = on_edges([=](int i, int j) { return at.phi.edge_xy(i, j, k); },
                                [=](int i) { return at.share.xy(i, k); },
                                [=](int i, int j) { return at.template stretch_xy<kNeoHookean>(i, j, k); });
    const auto on_yz = on_edges([=](int i, int j) { return at.phi.edge_yz(i, j, k); },
                                [=](int i) { return at.share.yz(i, k); },
                                [=](int i, int j) { return at.template stretch_yz<kNeoHookean>(i, j, k); });
    const auto on_centers = [=](Side& side, int j) {
      const bool in_band = j > first_row;
      fill(side.own.data(), nx, [=](int i) {
        return in_band ? at.template center<kViscous>(i, j - 1, k,
                                                      at.template stretch_center<kNeoHookean>(i, j - 1, k))
                       : 0;
      });
    };
    solve<kViscous>({g.inv_dy.data(), first_row, k, driving}, on_xy, before.x.view(), velocity.x.view());
    solve<false>({g.inv_dy_face.data(), std::max(first_row, 1), k, 0}, on_centers, before.y.view(),
                 velocity.y.view());
    solve<kViscous>({g.inv_dy.data(), first_row, k, 0}, on_yz, before.z.view(), velocity.z.view());
  }
}

/// Gaussian elimination for the columns of a plane side by side. c(side, j) fills the coefficients of the
/// edges below the unknowns of row j; beyond both ends q = 0.
template <bool kAbove, class Coefficients>
void RowStiffness::solve(const Systems& systems, const Coefficients& c, View<const Real> before,
                         View<Real> velocity) {
  eliminate<kAbove>(systems, c, before, velocity);
  substitute_back<kAbove>(systems, before, velocity);
}

/// Upwards. Each row in turn becomes
///   q[j] = change[j] + ratio[j] q[j+1] + second_ratio[j] q[j+2].
template <bool kAbove, class Coefficients>
void RowStiffness::eliminate(const Systems& systems, const Coefficients& c, View<const Real> before,
                             View<Real> predicted) {
  const int nx = grid_.nx, row0 = systems.row0, k = systems.k;
  std::fill_n(rest_.data(), nx, Real(1));
  std::fill_n(row(change_, row0 - 1), nx, Real(0));
  if constexpr (kAbove) std::fill_n(row(second_ratio_, row0 - 1), nx, Real(0));
  c(low_, row0);
  for (int j = row0; j < grid_.ny; ++j) {
    c(high_, j + 1);
    eliminate_row<kAbove>(systems, j, &before(0, j, k), &predicted(0, j, k));
    std::swap(low_, high_);
  }
}

template <bool kAbove>
void RowStiffness::eliminate_row(const Systems& systems, int j, const Real* old, const Real* predicted) {
  const int nx = grid_.nx;
  const Real constant = systems.constant, factor = systems.inverse_height[j];
  const Real *const low = low_.own.data(), *const high = high_.own.data(),
                    *const low_above = low_.above.data(), *const high_above = high_.above.data();
  Real *const q = row(change_, j), *const f = row(ratio_, j), *const f2 = row(second_ratio_, j),
              *const rest = rest_.data();
  const Real *const below = row(change_, j - 1), *const f2_below = row(second_ratio_, j - 1);
#pragma omp simd
  for (int i = 0; i < nx; ++i) {
    const Real lower = factor * low[i];
    Real upper = factor * high[i], here = 1 + lower * rest[i];  // rest: 1 - ratio of the row below
    if constexpr (kAbove) {
      const Real second = factor * high_above[i];
      upper -= factor * low_above[i];
      const Real inverse = 1 / (here + upper);
      const Real first = upper - second + lower * f2_below[i];
      f[i] = first * inverse;
      f2[i] = second * inverse;
      rest[i] = 1 - f[i];
      q[i] = (predicted[i] - old[i] + constant + lower * below[i]) * inverse;
    } else {
      const Real inverse = 1 / (here + upper);
      rest[i] = here * inverse;
      f[i] = upper * inverse;
      q[i] = (predicted[i] - old[i] + constant + lower * below[i]) * inverse;
    }
  }
}

/// Downwards; adds q to the velocity before.
template <bool kAbove>
void RowStiffness::substitute_back(const Systems& systems, View<const Real> before, View<Real> velocity) {
  const int nx = grid_.nx, ny = grid_.ny, k = systems.k;
  const Real constant = systems.constant;
  for (int j = ny - 1; j >= systems.row0; --j) {
    Real* const q = row(change_, j);
    const Real *const f = row(ratio_, j), *const f2 = row(second_ratio_, j), *const old = &before(0, j, k);
    Real* const now = &velocity(0, j, k);
    if (j < ny - 1) {
      const Real* const above = row(change_, j + 1);
#pragma omp simd
      for (int i = 0; i < nx; ++i) q[i] += f[i] * above[i];
    }
    if (kAbove && j < ny - 2) {
      const Real* const above = row(change_, j + 2);
#pragma omp simd
      for (int i = 0; i < nx; ++i) q[i] += f2[i] * above[i];
    }
#pragma omp simd
    for (int i = 0; i < nx; ++i) now[i] = old[i] + (q[i] - constant);
  }
}

}  // namespace softwall::solid
