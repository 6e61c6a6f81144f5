#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "solver/fluid/momentum.hpp"

/// The right-hand side R of momentum.hpp in all cells, each flux computed once: the difference of the fluxes
/// through the high and the low sides of the control volumes. Low sides are remembered from the neighbour
/// that was done before, in y in a row, in z in a plane of a few rows, which stays in the cache.
namespace softwall::fluid {

/// R of one row of cells, components on their low faces; valid until the next row.
struct MomentumRow {
  const Real *x, *y, *z;
};

class MomentumSweep {
 public:
  explicit MomentumSweep(const Grid& g)
      : nx_(g.nx), nz_(g.nz), stride_((g.nx + 1 + kLine - 1) / kLine * kLine) {
    const auto row = static_cast<std::size_t>(stride_);
    for (YSide& side : y_) side = YSide{Row(row), Row(row), Row(row), Row(row)};
    for (ZSide& side : z_) side = ZSide{Row(row * kRows), Row(row * kRows), Row(row * kRows)};
    for (Row& component : rate_) component.resize(row);
  }

  /// Calls done(j, k, MomentumRow) for every row j0 <= j < j1 of every plane.
  template <class RowDone>
  void for_each_row(const MomentumInput& m, int j0, int j1, const RowDone& done) {
    for (int j = j0; j < j1; j += kRows) sweep(m, j, std::min(j + kRows, j1), done);
  }

 private:
  using Row = std::vector<Real>;
  static constexpr int kLine = 64 / sizeof(Real);
  static constexpr int kRows = 24;  ///< rows done together from plane to plane

  /// Fluxes through the y sides of a row of control volumes, named as in momentum.hpp, and flux_yx on the
  /// same edges.
  struct YSide {
    Row xy, yx, yy, zy;
  };
  /// Fluxes through the z sides of rows of control volumes.
  struct ZSide {
    Row xz, yz, zz;
  };

  /// Sides at the low face of row j of u and w, and at the center below it for v.
  void fill(YSide& side, const MomentumInput& m, int j, int k) const {
    Real *const xy = side.xy.data(), *const yx = side.yx.data(), *const yy = side.yy.data(),
                *const zy = side.zy.data();
#pragma omp simd
    for (int i = 0; i <= nx_; ++i) {
      xy[i] = flux_xy(m, i, j, k);
      yx[i] = flux_yx(m, i, j, k);
      yy[i] = flux_yy(m, i, j - 1, k);
      zy[i] = flux_zy(m, i, j, k);
    }
  }
  /// Sides of row j at the low face of plane k for u and v, and at the center below it for w.
  void fill(ZSide& side, std::ptrdiff_t row, const MomentumInput& m, int j, int k) const {
    Real *const xz = side.xz.data() + row, *const yz = side.yz.data() + row, *const zz = side.zz.data() + row;
#pragma omp simd
    for (int i = 0; i <= nx_; ++i) {
      xz[i] = flux_xz(m, i, j, k);
      yz[i] = flux_yz(m, i, j, k);
      zz[i] = flux_zz(m, i, j, k - 1);
    }
  }

  void add_up(const MomentumInput& m, int j, int k, std::ptrdiff_t row) {
    const YSide &low_y = y_[0], &high_y = y_[1];
    const ZSide &low_z = z_[0], &high_z = z_[1];
    const Real *const xy0 = low_y.xy.data(), *const xy1 = high_y.xy.data(), *const yx = low_y.yx.data();
    const Real *const yy0 = low_y.yy.data(), *const yy1 = high_y.yy.data();
    const Real *const zy0 = low_y.zy.data(), *const zy1 = high_y.zy.data();
    const Real *const xz0 = low_z.xz.data() + row, *const xz1 = high_z.xz.data() + row;
    const Real *const yz0 = low_z.yz.data() + row, *const yz1 = high_z.yz.data() + row;
    const Real *const zz0 = low_z.zz.data() + row, *const zz1 = high_z.zz.data() + row;
    Real *const x = rate_[0].data(), *const y = rate_[1].data(), *const z = rate_[2].data();
    const Real inv_dx = m.inv_dx, inv_dz = m.inv_dz, inv_dy = m.inv_dy[j], inv_dy_face = m.inv_dy_face[j];
#pragma omp simd
    for (int i = 0; i < nx_; ++i) {
      const Real xx = flux_xx(m, i, j, k) - flux_xx(m, i - 1, j, k);
      x[i] = xx * inv_dx + (xy1[i] - xy0[i]) * inv_dy + (xz1[i] - xz0[i]) * inv_dz;
      y[i] = (yx[i + 1] - yx[i]) * inv_dx + (yy1[i] - yy0[i]) * inv_dy_face + (yz1[i] - yz0[i]) * inv_dz;
      z[i] = (xz0[i + 1] - xz0[i]) * inv_dx + (zy1[i] - zy0[i]) * inv_dy + (zz1[i] - zz0[i]) * inv_dz;
    }
  }

  template <class RowDone>
  void sweep(const MomentumInput& m, int j0, int j1, const RowDone& done) {
    const auto row_of = [&](int j) { return std::ptrdiff_t(j - j0) * stride_; };
    for (int j = j0; j < j1; ++j) fill(z_[0], row_of(j), m, j, 0);
    for (int k = 0; k < nz_; ++k) {
      fill(y_[0], m, j0, k);
      for (int j = j0; j < j1; ++j) {
        fill(y_[1], m, j + 1, k);
        fill(z_[1], row_of(j), m, j, k + 1);
        add_up(m, j, k, row_of(j));
        done(j, k, MomentumRow{rate_[0].data(), rate_[1].data(), rate_[2].data()});
        std::swap(y_[0], y_[1]);
      }
      std::swap(z_[0], z_[1]);
    }
  }

  int nx_, nz_;
  std::ptrdiff_t stride_;
  std::array<YSide, 2> y_;  ///< low, high
  std::array<ZSide, 2> z_;
  std::array<Row, 3> rate_;
};

}  // namespace softwall::fluid
