#pragma once

#include <utility>

#include "solver/grid/field.hpp"
#include "solver/parallel/line_memory.hpp"

/// Force of a stress whose normal components live at centers and shear components on edges, as those of B do:
///   f_i = d s_ij / dx_j
/// on the faces. Shear stresses, of which each acts on four faces, are found a row at a time; those on the
/// edges between two rows of cells serve both.
///
/// A stress has xx(i, j, k), ..., yz(i, j, k), where the components live, and kAcrossRowsOnly: whether all
/// but xy and yz are zero.
namespace softwall::solid {

using grid::Real;

class StressDivergence {
 public:
  explicit StressDivergence(const grid::Grid& g) : grid_(g) {
    const auto length = static_cast<std::size_t>(parallel::whole_lines<Real>(g.nx + 1));
    for (Row* row : {&low_.xy, &low_.yz, &high_.xy, &high_.yz, &xz_, &next_.xz, &next_.yz})
      row->resize(length);
  }

  /// Writes the force in rows j0 <= j < j1 of plane k, but for y faces on the lower wall, row 0.
  template <class Stress>
  void find(const Stress& s, int j0, int j1, int k, grid::VectorField& force) {
    fill(low_, s, j0, k);
    for (int j = j0; j < j1; ++j) {
      fill(high_, s, j + 1, k);
      fill(next_.yz, nx(), [=](int i) { return s.yz(i, j, k + 1); });
      if constexpr (!Stress::kAcrossRowsOnly) {
        fill(xz_, nx() + 1, [=](int i) { return s.xz(i, j, k); });
        fill(next_.xz, nx(), [=](int i) { return s.xz(i, j, k + 1); });
      }
      add_up(s, j, k, force);
      std::swap(low_, high_);
    }
  }

 private:
  using Row = parallel::LineVector<Real>;
  struct AcrossRows {
    Row xy, yz;
  };
  struct NextPlane {
    Row xz, yz;
  };

  [[nodiscard]] int nx() const { return grid_.nx; }

  template <class Component>
  static void fill(Row& row, int end, const Component& component) {
    Real* const to = row.data();
#pragma omp simd
    for (int i = 0; i < end; ++i) to[i] = component(i);
  }
  template <class Stress>
  void fill(AcrossRows& rows, const Stress& s, int j, int k) const {
    fill(rows.xy, nx() + 1, [=](int i) { return s.xy(i, j, k); });
    fill(rows.yz, nx(), [=](int i) { return s.yz(i, j, k); });
  }

  template <class Stress>
  void add_up(const Stress& stress, int j, int k, grid::VectorField& force) const {
    const Stress s = stress;  // a copy, which what the loops write cannot change
    const Real inv_dx = Real(1 / grid_.dx), inv_dz = Real(1 / grid_.dz), inv_dy = grid_.inv_dy[j],
               inv_dy_face = grid_.inv_dy_face[j];
    const Real *const xy0 = low_.xy.data(), *const xy1 = high_.xy.data(), *const yz0 = low_.yz.data(),
                      *const yz1 = high_.yz.data(), *const next_yz = next_.yz.data(), *const xz = xz_.data(),
                      *const next_xz = next_.xz.data();
    Real *const x = &force.x.view()(0, j, k), *const y = &force.y.view()(0, j, k),
                *const z = &force.z.view()(0, j, k);
    const int end = nx();
#pragma omp simd
    for (int i = 0; i < end; ++i) {
      Real force_x = (xy1[i] - xy0[i]) * inv_dy, force_z = (yz1[i] - yz0[i]) * inv_dy;
      if constexpr (!Stress::kAcrossRowsOnly) {
        force_x += (s.xx(i, j, k) - s.xx(i - 1, j, k)) * inv_dx + (next_xz[i] - xz[i]) * inv_dz;
        force_z += (xz[i + 1] - xz[i]) * inv_dx + (s.zz(i, j, k) - s.zz(i, j, k - 1)) * inv_dz;
      }
      x[i] = force_x;
      z[i] = force_z;
    }
    if (j == 0) return;
#pragma omp simd
    for (int i = 0; i < end; ++i) {
      Real force_y = (xy0[i + 1] - xy0[i]) * inv_dx + (next_yz[i] - yz0[i]) * inv_dz;
      if constexpr (!Stress::kAcrossRowsOnly) {
        force_y += (s.yy(i, j, k) - s.yy(i, j - 1, k)) * inv_dy_face;
      }
      y[i] = force_y;
    }
  }

  const grid::Grid& grid_;
  AcrossRows low_, high_;
  Row xz_;
  NextPlane next_;
};

}  // namespace softwall::solid
