#include "solver/solid/reference_map/extrapolation.hpp"

#include <algorithm>

namespace softwall::solid::reference_map {

/// Between which the slope of a line is kept.
struct Extrapolation::Bounds {
  Real least, most;
  [[nodiscard]] Real within(Real slope) const {
    const Real high = slope < most ? slope : most;
    return high > least ? high : least;
  }
};

namespace {

/// The larger of both; in z only where the flow has more than one cell.
double horizontal_spacing(const Grid& g) { return g.nz_global > 1 ? std::max(g.dx, g.dz) : g.dx; }

/// The slope between neighbours, as far as it agrees with that of the parabola.
Real held_slope(Real between_neighbours, Real of_parabola) {
  constexpr Real kFurthest = Real(0.1);
  const Real off = between_neighbours - of_parabola, less = off < kFurthest ? off : kFurthest;
  return of_parabola + (less > -kFurthest ? less : -kFurthest);
}

}  // namespace

Extrapolation::Extrapolation(const Grid& grid)
    : grid_(grid),
      span_(horizontal_spacing(grid) / 2),
      surface_(static_cast<std::size_t>(grid.nx)),
      slope_(static_cast<std::size_t>(grid.nx)) {}

/// Returns the first row that is at least `height` above row j. Near the upper wall it is one beyond it,
/// where the displacement is mirrored.
int Extrapolation::row_above(const grid::RowArray& y, int j, double height) const {
  constexpr double kRoundOff = 1e-6;
  const double enough = height * (1 - kRoundOff);
  int upper = j + 1;
  while (upper < grid_.ny && y[upper] - y[j] < enough) ++upper;
  return upper;
}

/// A parabola through row j, the row a span above it and one two spans above it has at row j the slope
/// near (d(nearer) - d(j)) + far (d(farther) - d(j)).
Extrapolation::Parabola Extrapolation::parabola_at(const grid::RowArray& y, int j) const {
  const int nearer = row_above(y, j, span_), farther = row_above(y, nearer, span_);
  const double a = y[nearer] - y[j], b = y[farther] - y[j];
  return {nearer, farther, Real(b / (a * (b - a))), Real(-a / (b * (b - a)))};
}

/// surface(i, k): its height where the component lives; y: heights of the component's rows, of which the
/// highest always counts as solid. Walks down from the lowest row that is solid along the whole line.
template <class SurfaceAt>
void Extrapolation::extend(View<Real> d, const grid::RowArray& y, int j0, const Bounds& slopes,
                           const SurfaceAt& surface) {
  const int nx = grid_.nx, top = grid_.ny - 1;
  double* const eta = surface_.data();
  Real* const slope = slope_.data();
  const auto line_from = [=, this, &y](int j, int k) {
    const Parabola p = parabola_at(y, j);
    const Real to_next = 1 / Real(y[j + 1] - y[j]);
    return [=](int i) {
      const Real own = d(i, j, k);
      const Real of_parabola = (d(i, p.nearer, k) - own) * p.near + (d(i, p.farther, k) - own) * p.far;
      return slopes.within(held_slope((d(i, j + 1, k) - own) * to_next, of_parabola));
    };
  };
  for (int k = 0; k < grid_.nz; ++k) {
    double highest = y[j0];
#pragma omp simd reduction(max : highest)
    for (int i = 0; i < nx; ++i) {
      eta[i] = surface(i, k);
      highest = eta[i] > highest ? eta[i] : highest;
    }
    int solid = top;
    while (solid > j0 && y[solid - 1] >= highest) --solid;
    const auto highest_line = line_from(solid, k);
#pragma omp simd
    for (int i = 0; i < nx; ++i) slope[i] = highest_line(i);
    for (int j = solid - 1; j >= j0; --j) {
      const double here = y[j];
      const Real height = Real(y[j + 1] - y[j]);
      const auto own_line = line_from(j, k);
#pragma omp simd
      for (int i = 0; i < nx; ++i) {
        const bool is_solid = here >= eta[i];
        const Real own = d(i, j, k), above = d(i, j + 1, k);
        const Real line = is_solid ? own_line(i) : slope[i];
        slope[i] = line;
        d(i, j, k) = is_solid ? own : above - line * height;
      }
    }
  }
}

void Extrapolation::extend(const Heights& eta, int j0, grid::VectorField& d) {
  constexpr Bounds kAlongSurface{-2, 2}, kUpright{-1, 0.5};
  const Grid& g = grid_;
  extend(d.x.view(), g.y_center, j0, kAlongSurface,
         [&](int i, int k) { return (eta(i - 1, k) + eta(i, k)) / 2; });
  extend(d.y.view(), g.y_face, j0, kUpright, [&](int i, int k) { return eta(i, k); });
  extend(d.z.view(), g.y_center, j0, kAlongSurface,
         [&](int i, int k) { return (eta(i, k - 1) + eta(i, k)) / 2; });
}

}  // namespace softwall::solid::reference_map
