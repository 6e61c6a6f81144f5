#include "solver/solid/reference_map/extrapolation.hpp"

#include <vector>

namespace softwall::solid::reference_map {

namespace {

/// Bounds of the slope of a line.
struct Bounds {
  Real least, most;
  [[nodiscard]] Real within(Real slope) const {
    const Real high = slope < most ? slope : most;
    return high > least ? high : least;
  }
};
constexpr Bounds kAlongSurface{-2, 2}, kUpright{-1, 0.5};

/// Walks down from row `top`, which always counts as solid. surface(i, k): height of the surface where the
/// component lives; y: heights of its rows; bounds: of the slope.
template <class SurfaceAt>
void extend(View<Real> d, const Grid& g, const grid::RowArray& y, int top, int j0, const Bounds& bounds,
            const SurfaceAt& surface) {
  const auto nx = static_cast<std::size_t>(g.nx);
  std::vector<double> surfaces(nx);
  std::vector<Real> slopes(nx);
  double* const eta = surfaces.data();
  Real* const slope = slopes.data();
  for (int k = 0; k < g.nz; ++k) {
    for (int i = 0; i < g.nx; ++i) {
      eta[i] = surface(i, k);
      slope[i] = bounds.within((d(i, top + 1, k) - d(i, top, k)) / Real(y[top + 1] - y[top]));
    }
    for (int j = top - 1; j >= j0; --j) {
      const double here = y[j];
      const Real height = Real(y[j + 1] - y[j]), inverse = 1 / height;
#pragma omp simd
      for (int i = 0; i < g.nx; ++i) {
        const bool solid = here >= eta[i];
        const Real own = d(i, j, k), above = d(i, j + 1, k);
        const Real line = solid ? bounds.within((above - own) * inverse) : slope[i];
        slope[i] = line;
        d(i, j, k) = solid ? own : above - line * height;
      }
    }
  }
}

}  // namespace

void extrapolate(const Heights& eta, const Grid& g, int j0, grid::VectorField& d) {
  const int top = g.ny - 1;
  extend(d.x.view(), g, g.y_center, top, j0, kAlongSurface,
         [&](int i, int k) { return (eta(i - 1, k) + eta(i, k)) / 2; });
  extend(d.y.view(), g, g.y_face, top, j0, kUpright, [&](int i, int k) { return eta(i, k); });
  extend(d.z.view(), g, g.y_center, top, j0, kAlongSurface,
         [&](int i, int k) { return (eta(i, k - 1) + eta(i, k)) / 2; });
}

}  // namespace softwall::solid::reference_map
