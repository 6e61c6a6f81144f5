#include "solver/solid/reference_map/strain_sweep.hpp"

#include <utility>

namespace softwall::solid::reference_map {

namespace {

/// Runs the kernel in columns first <= i < end of a row.
template <class Kernel>
[[gnu::always_inline]] inline void along_row(int first, int end, const Kernel& kernel) {
#pragma omp simd
  for (int i = first; i < end; ++i) kernel(i);
}

/// Element 0 of a row is that of column 0; a line of the cache before it holds that of column -1.
constexpr int kBefore = parallel::kLineBytes / sizeof(Real);
template <class Row>
auto first(Row& row) {
  return row.data() + kBefore;
}

}  // namespace

StrainSweep::StrainSweep(const Grid& g) : nx_(g.nx), ny_(g.ny), nz_(g.nz) {
  const auto length = static_cast<std::size_t>(parallel::whole_lines<Real>(kBefore + g.nx + 1));
  for (CellRow* row : {&below_, &above_}) {
    for (auto* means : {&row->to_xy, &row->to_yz}) {
      for (Row* r : {&means->xx, &means->yy, &means->zz, &means->xz, &means->zx}) r->resize(length);
    }
  }
  for (FaceRow* row : {&low_, &high_}) {
    for (auto* halves : {&row->to_center, &row->to_xz}) {
      for (Row* r : {&halves->xy, &halves->yx, &halves->yz, &halves->zy}) r->resize(length);
    }
  }
}

std::int64_t StrainSweep::run(const Strain& strain, View<const Real> phi, int first_row,
                              const StrainFields& to, Damage& damage, PlaneFollower& follower) {
  std::int64_t torn = 0;
  for (int k = -1; k <= nz_; ++k) {
    const bool has_centers = k < nz_, has_edges = k >= 0;
    if (has_edges) average(below_, strain, first_row - 1, k);
    average(low_, strain, first_row, k);
    for (int j = first_row; j <= ny_; ++j) {
      if (has_edges) {
        average(above_, strain, j, k);
        edges_xy(strain, j, k, to.xy);
        edges_yz(strain, j, k, to.yz);
        std::swap(below_, above_);
      }
      if (j == ny_) break;
      average(high_, strain, j + 1, k);
      if (has_centers) {
        centers(strain, phi, j, k, to, damage);
        const int torn_in_row = damage.finish_row(j, k, to.xx, to.zz);
        if (has_edges) torn += torn_in_row;
      }
      if (has_edges) edges_xz(strain, j, k, to.xz);
      std::swap(low_, high_);
    }
    if (k > 0) follower.plane_is_ready(k - 1);
  }
  return torn;
}

void StrainSweep::average(CellRow& row, const Strain& s, int j, int k) const {
  const auto x = s.x, y = s.y, z = s.z;
  const Real in_x = s.inv_dx / 2, in_y = s.inv_dy[j] / 2, in_z = s.inv_dz / 2;
  {
    Real *const xx = first(row.to_xy.xx), *const yy = first(row.to_xy.yy), *const zz = first(row.to_xy.zz),
                *const xz = first(row.to_xy.xz), *const zx = first(row.to_xy.zx);
    along_row(0, nx_ + 1, [=](int i) {
      xx[i] = 1 - in_x * (x(i + 1, j, k) - x(i - 1, j, k));
      yy[i] = 1 - in_y * (y(i, j + 1, k) - y(i, j, k) + (y(i - 1, j + 1, k) - y(i - 1, j, k)));
      zz[i] = 1 - in_z * (z(i, j, k + 1) - z(i, j, k) + (z(i - 1, j, k + 1) - z(i - 1, j, k)));
      xz[i] = -in_z * (x(i, j, k + 1) - x(i, j, k - 1));
      zx[i] = -in_x * (z(i, j, k) - z(i - 1, j, k) + (z(i, j, k + 1) - z(i - 1, j, k + 1)));
    });
  }
  Real *const xx = first(row.to_yz.xx), *const yy = first(row.to_yz.yy), *const zz = first(row.to_yz.zz),
              *const xz = first(row.to_yz.xz), *const zx = first(row.to_yz.zx);
  along_row(0, nx_, [=](int i) {
    xx[i] = 1 - in_x * (x(i + 1, j, k) - x(i, j, k) + (x(i + 1, j, k - 1) - x(i, j, k - 1)));
    yy[i] = 1 - in_y * (y(i, j + 1, k) - y(i, j, k) + (y(i, j + 1, k - 1) - y(i, j, k - 1)));
    zz[i] = 1 - in_z * (z(i, j, k + 1) - z(i, j, k - 1));
    xz[i] = -in_z * (x(i, j, k) - x(i, j, k - 1) + (x(i + 1, j, k) - x(i + 1, j, k - 1)));
    zx[i] = -in_x * (z(i + 1, j, k) - z(i - 1, j, k));
  });
}

void StrainSweep::average(FaceRow& row, const Strain& s, int j, int k) const {
  const auto x = s.x, y = s.y, z = s.z;
  const Real in_x = s.inv_dx / 4, in_y = s.inv_dy_face[j] / 4, in_z = s.inv_dz / 4;
  {
    Real *const xy = first(row.to_center.xy), *const yx = first(row.to_center.yx),
                *const yz = first(row.to_center.yz), *const zy = first(row.to_center.zy);
    along_row(-1, nx_, [=](int i) {
      xy[i] = -in_y * (x(i, j, k) - x(i, j - 1, k) + (x(i + 1, j, k) - x(i + 1, j - 1, k)));
      yx[i] = -in_x * (y(i + 1, j, k) - y(i - 1, j, k));
      yz[i] = -in_z * (y(i, j, k + 1) - y(i, j, k - 1));
      zy[i] = -in_y * (z(i, j, k) - z(i, j - 1, k) + (z(i, j, k + 1) - z(i, j - 1, k + 1)));
    });
  }
  Real *const xy = first(row.to_xz.xy), *const yx = first(row.to_xz.yx), *const yz = first(row.to_xz.yz),
              *const zy = first(row.to_xz.zy);
  along_row(0, nx_ + 1, [=](int i) {
    xy[i] = -in_y * (x(i, j, k) - x(i, j - 1, k) + (x(i, j, k - 1) - x(i, j - 1, k - 1)));
    yx[i] = -in_x * (y(i, j, k) - y(i - 1, j, k) + (y(i, j, k - 1) - y(i - 1, j, k - 1)));
    yz[i] = -in_z * (y(i, j, k) - y(i, j, k - 1) + (y(i - 1, j, k) - y(i - 1, j, k - 1)));
    zy[i] = -in_y * (z(i, j, k) - z(i, j - 1, k) + (z(i - 1, j, k) - z(i - 1, j - 1, k)));
  });
}

void StrainSweep::centers(const Strain& s, View<const Real> phi, int j, int k, const StrainFields& to,
                          Damage& damage) {
  const auto damage_at = damage.view();
  const auto x = s.x, y = s.y, z = s.z;
  const auto &a = low_.to_center, &b = high_.to_center;
  const Real *const xy0 = first(a.xy), *const xy1 = first(b.xy), *const yx0 = first(a.yx),
                    *const yx1 = first(b.yx), *const yz0 = first(a.yz), *const yz1 = first(b.yz),
                    *const zy0 = first(a.zy), *const zy1 = first(b.zy);
  const Real inv_dx = s.inv_dx, inv_dy = s.inv_dy[j], inv_dz = s.inv_dz, in_x = inv_dx / 4, in_z = inv_dz / 4;
  along_row(-1, nx_, [=](int i) {
    const MapGradient A{1 - inv_dx * (x(i + 1, j, k) - x(i, j, k)),
                        xy0[i] + xy1[i],
                        -in_z * (x(i, j, k + 1) - x(i, j, k - 1) + (x(i + 1, j, k + 1) - x(i + 1, j, k - 1))),
                        yx0[i] + yx1[i],
                        1 - inv_dy * (y(i, j + 1, k) - y(i, j, k)),
                        yz0[i] + yz1[i],
                        -in_x * (z(i + 1, j, k) - z(i - 1, j, k) + (z(i + 1, j, k + 1) - z(i - 1, j, k + 1))),
                        zy0[i] + zy1[i],
                        1 - inv_dz * (z(i, j, k + 1) - z(i, j, k))};
    const Real J = A.determinant();
    const FactorOfB of(J);
    to.volume_error(i, j, k) = volume_error(phi(i, j, k), J);
    const Real xx = of.factor * A.square_x() + of.rest, yy = of.factor * A.square_y() + of.rest,
               zz = of.factor * A.square_z() + of.rest;
    damage_at(i, j, k) = damage_of(phi(i, j, k), J, xx + yy + zz);
    to.xx(i, j, k) = bounded(xx);
    to.yy(i, j, k) = bounded(yy);
    to.zz(i, j, k) = bounded(zz);
  });
}

void StrainSweep::edges_xz(const Strain& s, int j, int k, View<Real> to) const {
  const auto x = s.x, y = s.y, z = s.z;
  const auto &a = low_.to_xz, &b = high_.to_xz;
  const Real *const xy0 = first(a.xy), *const xy1 = first(b.xy), *const yx0 = first(a.yx),
                    *const yx1 = first(b.yx), *const yz0 = first(a.yz), *const yz1 = first(b.yz),
                    *const zy0 = first(a.zy), *const zy1 = first(b.zy);
  const Real inv_dx = s.inv_dx, inv_dz = s.inv_dz, in_x = inv_dx / 4, in_y = s.inv_dy[j] / 4,
             in_z = inv_dz / 4;
  along_row(0, nx_ + 1, [=](int i) {
    const Real rise = y(i, j + 1, k) - y(i, j, k) + (y(i - 1, j + 1, k) - y(i - 1, j, k)) +
                      (y(i, j + 1, k - 1) - y(i, j, k - 1) + (y(i - 1, j + 1, k - 1) - y(i - 1, j, k - 1)));
    const MapGradient A{
        1 - in_x * (x(i + 1, j, k) - x(i - 1, j, k) + (x(i + 1, j, k - 1) - x(i - 1, j, k - 1))),
        xy0[i] + xy1[i],
        -inv_dz * (x(i, j, k) - x(i, j, k - 1)),
        yx0[i] + yx1[i],
        1 - in_y * rise,
        yz0[i] + yz1[i],
        -inv_dx * (z(i, j, k) - z(i - 1, j, k)),
        zy0[i] + zy1[i],
        1 - in_z * (z(i, j, k + 1) - z(i, j, k - 1) + (z(i - 1, j, k + 1) - z(i - 1, j, k - 1)))};
    to(i, j, k) = bounded(FactorOfB(A.determinant()).factor * A.product_xz());
  });
}

void StrainSweep::edges_xy(const Strain& s, int j, int k, View<Real> to) const {
  const auto x = s.x, y = s.y, z = s.z;
  const auto &a = below_.to_xy, &b = above_.to_xy;
  const Real *const xx0 = first(a.xx), *const xx1 = first(b.xx), *const yy0 = first(a.yy),
                    *const yy1 = first(b.yy), *const zz0 = first(a.zz), *const zz1 = first(b.zz),
                    *const xz0 = first(a.xz), *const xz1 = first(b.xz), *const zx0 = first(a.zx),
                    *const zx1 = first(b.zx);
  const Real up = s.upper_share[j], inv_dx = s.inv_dx, inv_dy = s.inv_dy_face[j], in_y = inv_dy / 4,
             in_z = s.inv_dz / 4;
  along_row(0, nx_ + 1, [=](int i) {
    const Real rise = z(i, j, k) - z(i, j - 1, k) + (z(i - 1, j, k) - z(i - 1, j - 1, k)) +
                      (z(i, j, k + 1) - z(i, j - 1, k + 1) + (z(i - 1, j, k + 1) - z(i - 1, j - 1, k + 1)));
    const MapGradient A{xx0[i] + up * (xx1[i] - xx0[i]),
                        -inv_dy * (x(i, j, k) - x(i, j - 1, k)),
                        xz0[i] + up * (xz1[i] - xz0[i]),
                        -inv_dx * (y(i, j, k) - y(i - 1, j, k)),
                        yy0[i] + up * (yy1[i] - yy0[i]),
                        -in_z * (y(i, j, k + 1) - y(i, j, k - 1) + (y(i - 1, j, k + 1) - y(i - 1, j, k - 1))),
                        zx0[i] + up * (zx1[i] - zx0[i]),
                        -in_y * rise,
                        zz0[i] + up * (zz1[i] - zz0[i])};
    to(i, j, k) = bounded(FactorOfB(A.determinant()).factor * A.product_xy());
  });
}

void StrainSweep::edges_yz(const Strain& s, int j, int k, View<Real> to) const {
  const auto x = s.x, y = s.y, z = s.z;
  const auto &a = below_.to_yz, &b = above_.to_yz;
  const Real *const xx0 = first(a.xx), *const xx1 = first(b.xx), *const yy0 = first(a.yy),
                    *const yy1 = first(b.yy), *const zz0 = first(a.zz), *const zz1 = first(b.zz),
                    *const xz0 = first(a.xz), *const xz1 = first(b.xz), *const zx0 = first(a.zx),
                    *const zx1 = first(b.zx);
  const Real up = s.upper_share[j], inv_dz = s.inv_dz, inv_dy = s.inv_dy_face[j], in_x = s.inv_dx / 4,
             in_y = inv_dy / 4;
  along_row(0, nx_, [=](int i) {
    const Real rise = x(i, j, k) - x(i, j - 1, k) + (x(i + 1, j, k) - x(i + 1, j - 1, k)) +
                      (x(i, j, k - 1) - x(i, j - 1, k - 1) + (x(i + 1, j, k - 1) - x(i + 1, j - 1, k - 1)));
    const MapGradient A{xx0[i] + up * (xx1[i] - xx0[i]),
                        -in_y * rise,
                        xz0[i] + up * (xz1[i] - xz0[i]),
                        -in_x * (y(i + 1, j, k) - y(i - 1, j, k) + (y(i + 1, j, k - 1) - y(i - 1, j, k - 1))),
                        yy0[i] + up * (yy1[i] - yy0[i]),
                        -inv_dz * (y(i, j, k) - y(i, j, k - 1)),
                        zx0[i] + up * (zx1[i] - zx0[i]),
                        -inv_dy * (z(i, j, k) - z(i, j - 1, k)),
                        zz0[i] + up * (zz1[i] - zz0[i])};
    to(i, j, k) = bounded(FactorOfB(A.determinant()).factor * A.product_yz());
  });
}

}  // namespace softwall::solid::reference_map
