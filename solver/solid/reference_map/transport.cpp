#include "solver/solid/reference_map/transport.hpp"

#include <algorithm>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/weno.hpp"

namespace softwall::solid::reference_map {

namespace {

/// Upwind derivative at a point from the differences between it and its six nearest neighbours in line,
/// d[m]: from neighbour m - 3 to m - 2.
template <WenoWeights kWeights>
[[gnu::always_inline]] inline Real upwind_derivative(Real d0, Real d1, Real d2, Real d3, Real d4, Real d5,
                                                     Real velocity) {
  const bool forward = velocity > 0;
  return weno5<kWeights>(forward ? d0 : d5, forward ? d1 : d4, forward ? d2 : d3, forward ? d3 : d2,
                         forward ? d4 : d1);
}

/// In double precision Z weights know no unit (their tiny number is too small to matter), so that there the
/// spacing may be left to the end.
template <WenoWeights kWeights>
[[gnu::always_inline]] inline Real along(const Real* q, std::ptrdiff_t stride, Real inv_spacing,
                                         Real velocity) {
  constexpr bool kAtEnd = kWeights == WenoWeights::kZ && sizeof(Real) == sizeof(double);
  const Real before = kAtEnd ? 1 : inv_spacing, after = kAtEnd ? inv_spacing : 1;
  const auto difference = [=](int m) { return (q[m * stride] - q[(m - 1) * stride]) * before; };
  return after * upwind_derivative<kWeights>(difference(-2), difference(-1), difference(0), difference(1),
                                             difference(2), difference(3), velocity);
}

/// Upwind derivative in y, where spacings differ: inv_below[m] is that between rows j + m - 1 and j + m.
template <WenoWeights kWeights>
[[gnu::always_inline]] inline Real along_y(const Real* q, std::ptrdiff_t stride, const Real* inv_below,
                                           Real velocity) {
  const auto difference = [=](int m) { return (q[m * stride] - q[(m - 1) * stride]) * inv_below[m]; };
  return upwind_derivative<kWeights>(difference(-2), difference(-1), difference(0), difference(1),
                                     difference(2), difference(3), velocity);
}

/// The velocity where a component of the displacement lives; own: what of it moves the component, less what
/// the relaxation of volume takes away.
struct Around {
  View<const Real> u, v, w;
  const Real* upper_share;
  VolumeRelaxation out;
  template <class Q>
  Real across_y(int j, const Q& q) const {
    return upper_share[j] * q(j) + (1 - upper_share[j]) * q(j - 1);
  }
};
struct OnXFace : Around {
  Real x(int i, int j, int k) const { return u(i, j, k); }
  Real y(int i, int j, int k) const {
    return (v(i, j, k) + v(i - 1, j, k) + v(i, j + 1, k) + v(i - 1, j + 1, k)) / 4;
  }
  Real z(int i, int j, int k) const {
    return (w(i, j, k) + w(i - 1, j, k) + w(i, j, k + 1) + w(i - 1, j, k + 1)) / 4;
  }
  Real own(int i, int j, int k) const { return x(i, j, k) - out.x(i, j, k); }
};
struct OnYFace : Around {
  Real x(int i, int j, int k) const {
    return across_y(j, [=, this](int row) { return (u(i, row, k) + u(i + 1, row, k)) / 2; });
  }
  Real y(int i, int j, int k) const { return v(i, j, k); }
  Real z(int i, int j, int k) const {
    return across_y(j, [=, this](int row) { return (w(i, row, k) + w(i, row, k + 1)) / 2; });
  }
  Real own(int i, int j, int k) const { return y(i, j, k) - out.y(i, j, k); }
};
struct OnZFace : Around {
  Real x(int i, int j, int k) const {
    return (u(i, j, k) + u(i, j, k - 1) + u(i + 1, j, k) + u(i + 1, j, k - 1)) / 4;
  }
  Real y(int i, int j, int k) const {
    return (v(i, j, k) + v(i, j, k - 1) + v(i, j + 1, k) + v(i, j + 1, k - 1)) / 4;
  }
  Real z(int i, int j, int k) const { return w(i, j, k); }
  Real own(int i, int j, int k) const { return z(i, j, k) - out.z(i, j, k); }
};

template <WenoWeights kWeights, class PointVelocity>
void rate_of(const grid::Field& component, const PointVelocity& velocity, const Grid& g,
             const Real* inv_below, const RowsOfAPlane& rows, View<Real> rate) {
  const auto d = component.view();
  const Real inv_dx = Real(1 / g.dx), inv_dz = Real(1 / g.dz);
  grid::for_each_cell({0, g.nx, rows.j0, g.ny, rows.k, rows.k + 1}, [=](int i, int j, int k) {
    const Real* const q = &d(i, j, k);
    const Real a = velocity.x(i, j, k), b = velocity.y(i, j, k), c = velocity.z(i, j, k);
    rate(i, j, k) = velocity.own(i, j, k) - a * along<kWeights>(q, 1, inv_dx, a) -
                    b * along_y<kWeights>(q, d.stride_y, inv_below + j, b) -
                    c * along<kWeights>(q, d.stride_z, inv_dz, c);
  });
}

template <WenoWeights kWeights>
void find_rates(const grid::VectorField& d, const Around& around, const Grid& g, const RowsOfAPlane& rows,
                const PlaneOfRates& rates) {
  const Real *between_centers = g.inv_dy_face.data(), *between_faces = g.inv_dy.data() - 1;
  rate_of<kWeights>(d.x, OnXFace{around}, g, between_centers, rows, rates.x);
  rate_of<kWeights>(d.y, OnYFace{around}, g, between_faces, {rows.k, std::max(rows.j0, 1)}, rates.y);
  rate_of<kWeights>(d.z, OnZFace{around}, g, between_centers, rows, rates.z);
}

}  // namespace

void find_rates(const grid::VectorField& displacement, const grid::VectorField& velocity,
                const VolumeRelaxation& relaxation, const Grid& grid, WenoWeights weights,
                const RowsOfAPlane& rows, const PlaneOfRates& rates) {
  const Around around{velocity.x.view(), velocity.y.view(), velocity.z.view(), grid.upper_share.data(),
                      relaxation};
  if (weights == WenoWeights::kJiangShu) {
    find_rates<WenoWeights::kJiangShu>(displacement, around, grid, rows, rates);
  } else {
    find_rates<WenoWeights::kZ>(displacement, around, grid, rows, rates);
  }
}

}  // namespace softwall::solid::reference_map
