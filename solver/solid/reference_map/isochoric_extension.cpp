#include "solver/solid/reference_map/isochoric_extension.hpp"

#include <algorithm>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/reference_map/strain.hpp"

namespace softwall::solid::reference_map {

namespace {

/// Cells of a column whose volume is set: the one that the surface cuts, those whose gradients its stress
/// reads, and one that the surface may enter within a step. Further down the straight line goes on.
constexpr int kCells = 4;

/// Bounds of A_yy, and of what is changed of the straight line's: beyond them the lines of neighbouring
/// columns contradict each other, and the volume says nothing about d_y.
constexpr Real kLeast = 0.5, kMost = 2, kLargestChange = 0.3;
/// The least value of A_xx A_zz - A_xz A_zx that is divided by.
constexpr Real kLeastArea = 0.4;

Real clamp(Real value, Real least, Real most) {
  const Real high = value < most ? value : most;
  return high > least ? high : least;
}

/// What has to be added to A_yy for det A = 1.
[[gnu::always_inline]] inline Real change_of_yy(const MapGradient& A) {
  const Real area = A.f_yy(), others = A.determinant() - A.yy * area;
  const Real wanted = (1 - others) / (area > kLeastArea ? area : kLeastArea);
  return clamp(clamp(wanted, A.yy - kLargestChange, A.yy + kLargestChange), kLeast, kMost) - A.yy;
}

}  // namespace

/// A line of columns and their surface.
struct IsochoricExtension::Line {
  int k;
  const double* eta;
};

IsochoricExtension::IsochoricExtension(const Grid& grid)
    : grid_(grid),
      change_(grid, 0),
      lift_(static_cast<std::size_t>(grid.nx)),
      cells_left_(static_cast<std::size_t>(grid.nx)),
      top_row_(static_cast<std::size_t>(grid.nz)) {}

void IsochoricExtension::apply(const Heights& heights, int j0, grid::VectorField& d) {
  for (int k = 0; k < grid_.nz; ++k) top_row_[static_cast<std::size_t>(k)] = find_changes(heights, j0, k, d);
  const auto y = d.y.view();
  const auto change = std::as_const(change_).view();
  for (int k = 0; k < grid_.nz; ++k) {
    grid::for_each_cell({0, grid_.nx, j0, top_row_[static_cast<std::size_t>(k)], k, k + 1},
                        [=](int i, int j, int) { y(i, j, k) += change(i, j, k); });
  }
}

/// Walks down from the highest point of the surface over a line. Returns the row from which on nothing
/// changes.
int IsochoricExtension::find_changes(const Heights& heights, int j0, int k, const grid::VectorField& d) {
  const Line line{k, heights.row(k)};
  const double highest = *std::max_element(line.eta, line.eta + grid_.nx);
  int top = j0;
  while (top < grid_.ny && grid_.y_face[top] < highest) ++top;
  std::fill(lift_.begin(), lift_.end(), Real(0));
  std::fill(cells_left_.begin(), cells_left_.end(), kCells);
  int waiting = grid_.nx;
  for (int j = top - 1; j >= j0; --j) {
    if (waiting > 0) {
      waiting = find_row(line, j, d);
    } else {
      move_on(line, j);
    }
  }
  return top;
}

/// Sets the volume of cells j. Returns the number of columns that are not yet done.
int IsochoricExtension::find_row(const Line& line, int j, const grid::VectorField& d) {
  const Strain strain = strain_of(d, grid_);
  const auto change = change_.view();
  Real* const lift = lift_.data();
  int* const left = cells_left_.data();
  const double* const eta = line.eta;
  const double here = grid_.y_face[j];
  const Real dy = Real(grid_.dy[j]);
  const int k = line.k;
  int waiting = 0;
#pragma omp simd reduction(+ : waiting)
  for (int i = 0; i < grid_.nx; ++i) {
    const Real more = dy * change_of_yy(strain.center(i, j, k));
    const bool is_below = here < eta[i], is_set = is_below && left[i] > 0;
    lift[i] += is_set ? more : Real(0);
    left[i] -= is_set ? 1 : 0;
    waiting += left[i] > 0 ? 1 : 0;
    change(i, j, k) = is_below ? lift[i] : Real(0);
  }
  return waiting;
}

/// The straight lines go on from where the last cells that were set end.
void IsochoricExtension::move_on(const Line& line, int j) {
  std::copy(lift_.begin(), lift_.end(), &change_.view()(0, j, line.k));
}

}  // namespace softwall::solid::reference_map
