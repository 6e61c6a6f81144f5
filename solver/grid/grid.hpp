#pragma once

#include <vector>

#include "solver/case/case.hpp"
#include "solver/parallel/decomposition.hpp"

/// The staggered (MAC) grid of one rank.
///
///   y_face[j+1] ---- v(i,j+1) ----      cell (i,j,k): center (x_i + dx/2, y_center[j], z_k + dz/2)
///       |               |        |      u(i,j,k) on its low-x face, v on its low-y face, w on its low-z face
///     u(i,j)        p, phi    u(i+1,j)  p, phi and the normal components of B at the center
///       |            B_xx        |      B_xy(i,j,k) on the edge where the low-x and low-y faces meet,
///   B_xy(i,j) ------ v(i,j) -----       B_xz where low-x and low-z meet, B_yz where low-y and low-z meet
///
/// i, j, k count this rank's cells from 0; y is whole on every rank: v(i,0,k) and v(i,ny,k) lie on the walls.
namespace softwall::grid {

/// A number of a field. The solver is compiled once for each precision (CMakeLists.txt); what belongs to the
/// whole flow - time, steps, geometry, sums, statistics - is double in both.
#ifdef SOFTWALL_SINGLE
using Real = float;
inline constexpr Precision kPrecision = Precision::kSingle;
#else
using Real = double;
inline constexpr Precision kPrecision = Precision::kDouble;
#endif

/// One number for each row j = -kGhost .. ny + kGhost - 1, stored with its offset.
class RowArray {
 public:
  static constexpr int kGhost = 3;
  RowArray() = default;
  explicit RowArray(int ny)
      : values_(static_cast<std::size_t>(ny + 2 * kGhost + 1)), rounded_(values_.size()) {}
  double operator[](int j) const { return values_[place(j)]; }
  void set(int j, double value) {
    values_[place(j)] = value;
    rounded_[place(j)] = static_cast<Real>(value);
  }
  /// Address of row 0, for kernels that combine rows with fields.
  [[nodiscard]] const Real* data() const { return rounded_.data() + kGhost; }
  /// The numbers in double precision, for sums.
  [[nodiscard]] const double* exact() const { return values_.data() + kGhost; }

 private:
  static std::size_t place(int j) { return static_cast<std::size_t>(j + kGhost); }
  std::vector<double> values_;
  std::vector<Real> rounded_;
};

/// Spacings in h. Beyond a wall the cells are mirrored.
struct Grid {
  int nx_global = 0, nz_global = 0;
  int nx = 0, ny = 0, nz = 0;    ///< this rank's cells
  int x_begin = 0, z_begin = 0;  ///< global index of this rank's first cell
  int ny_fluid = 0;              ///< rows below the undeformed interface
  double length_x = 0, length_z = 0, height = 0;
  double dx = 0, dz = 0;
  bool walls_in_x = false;  ///< at x = 0 and length_x, where u(0, j, k) and u(nx, j, k) lie; else periodic
  RowArray y_face;          ///< j = 0 .. ny
  RowArray y_center;
  RowArray dy;       ///< cell height
  RowArray dy_face;  ///< y_center[j] - y_center[j-1], the height between centers across face j
  RowArray inv_dy, inv_dy_face;
  RowArray upper_share;  ///< dy[j] / (dy[j] + dy[j-1]): share of row j in the control volume around face j

  [[nodiscard]] double cells() const { return double(nx_global) * ny * nz_global; }
};

/// The part of a case's grid that belongs to this rank.
[[nodiscard]] Grid make_grid(const Physics& physics, const parallel::Decomposition& decomposition);

/// A grid in a box of any size with any faces (tests, other flows). faces: ny + 1 heights.
[[nodiscard]] Grid make_grid(int nx, int nz, double length_x, double length_z,
                             const std::vector<double>& faces, const parallel::Decomposition& decomposition);

}  // namespace softwall::grid
