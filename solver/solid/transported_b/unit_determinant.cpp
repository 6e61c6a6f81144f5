#include "solver/solid/transported_b/unit_determinant.hpp"

#include <algorithm>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/transported_b/limiter.hpp"

namespace softwall::solid {

double factor_of_normals(const SymmetricTensor& B) {
  constexpr double kLeast = 0.5, kMost = 0.1;
  const double determinant = B.determinant();
  // d det / d factor at 1: every normal component times its cofactor.
  const double slope =
      3 * B.xx * B.yy * B.zz - (B.xx * B.yz * B.yz + B.yy * B.xz * B.xz + B.zz * B.xy * B.xy);
  const bool is_strain = determinant > kLeast && slope > 0;
  return is_strain ? 1 + std::clamp((1 - determinant) / slope, -kMost, kMost) : 1;
}

void restore_unit_determinant(grid::TensorField& B, const Grid& grid, grid::Halo& halo, int first_row,
                              double share) {
  halo.fill({&B.xy, &B.xz, &B.yz}, {first_row, grid.ny + 1});
  const auto xx = B.xx.view(), yy = B.yy.view(), zz = B.zz.view();
  grid::for_each_cell(grid::rows(grid, first_row, grid.ny), [=, &B](int i, int j, int k) {
    const auto factor = Real(1 + share * (factor_of_normals(tensor_at_center(B, i, j, k)) - 1));
    xx(i, j, k) *= factor;
    yy(i, j, k) *= factor;
    zz(i, j, k) *= factor;
  });
}

}  // namespace softwall::solid
