#include "solver/solid/unit_determinant.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/limiter.hpp"

namespace softwall::solid {

namespace {

/// A smaller determinant belongs to a B that is no longer a strain (its limiter will lift it): blown up in
/// every substep, it would end the run.
constexpr double kLeast = 0.5;
/// What is taken out of a larger one in a substep.
constexpr double kMost = 2;

double scale_of(double determinant) {
  return determinant < kLeast ? 1.0 : 1 / std::cbrt(std::min(determinant, kMost));
}

}  // namespace

void UnitDeterminant::restore(grid::TensorField& B, int first_row) {
  const int ny = grid_.ny;
  halo_.fill({&B.xx, &B.yy, &B.zz, &B.xy, &B.xz, &B.yz}, {first_row, ny + 1});
  find_scale(B, first_row);
  const auto s = std::as_const(scale_).view();
  const auto centers = grid::rows(grid_, first_row, ny), faces = grid::rows(grid_, first_row, ny + 1);
  for (grid::Field* normal : {&B.xx, &B.yy, &B.zz}) {
    const auto q = normal->view();
    grid::for_each_cell(centers, [=](int i, int j, int k) { q(i, j, k) *= s(i, j, k); });
  }
  const auto xy = B.xy.view(), xz = B.xz.view(), yz = B.yz.view();
  grid::for_each_cell(faces, [=](int i, int j, int k) {
    xy(i, j, k) *= (s(i, j, k) + s(i - 1, j, k) + s(i, j - 1, k) + s(i - 1, j - 1, k)) / 4;
    yz(i, j, k) *= (s(i, j, k) + s(i, j, k - 1) + s(i, j - 1, k) + s(i, j - 1, k - 1)) / 4;
  });
  grid::for_each_cell(centers, [=](int i, int j, int k) {
    xz(i, j, k) *= (s(i, j, k) + s(i - 1, j, k) + s(i, j, k - 1) + s(i - 1, j, k - 1)) / 4;
  });
}

/// In one ghost column and plane on every side, too; the rows beyond the first and last repeat them.
void UnitDeterminant::find_scale(const grid::TensorField& B, int first_row) {
  const int nx = grid_.nx, ny = grid_.ny, nz = grid_.nz;
  const auto s = scale_.view();
  grid::for_each_cell({-1, nx + 1, first_row, ny, -1, nz + 1}, [=, &B](int i, int j, int k) {
    s(i, j, k) = Real(scale_of(tensor_at_center(B, i, j, k).determinant()));
  });
  for (const auto [beyond, row] : {std::pair{first_row - 1, first_row}, std::pair{ny, ny - 1}}) {
    grid::for_each_cell({-1, nx + 1, beyond, beyond + 1, -1, nz + 1},
                        [=, from = row](int i, int j, int k) { s(i, j, k) = s(i, from, k); });
  }
}

}  // namespace softwall::solid
