#pragma once

#include <initializer_list>

#include "solver/grid/cell_loop.hpp"
#include "solver/grid/field.hpp"
#include "solver/parallel/decomposition.hpp"
#include "solver/parallel/line_shift.hpp"
#include "solver/parallel/profile.hpp"

/// Ghost layers in x and z, filled from the neighbouring ranks (or from the rank itself). Both directions are
/// periodic, unless there are walls in x: beyond them the column at the wall is repeated, which is the
/// boundary condition of all but the velocity. Rows beyond the walls in y are not touched here: they follow
/// from boundary conditions, row by row.
namespace softwall::grid {

/// Rows to exchange: j0 <= j < j1, ghost rows included where wanted.
struct RowSpan {
  int j0 = 0, j1 = 0;
};

/// Fills the ghost cells at either end of a periodic row that is whole on this rank, of nx cells, not fewer
/// than `ghost`; `row`: its cell 0.
inline void wrap_row(Real* row, int nx, int ghost) {
  for (int g = 0; g < ghost; ++g) {
    row[nx + g] = row[g];
    row[-1 - g] = row[nx - 1 - g];
  }
}

/// One side of every rank's box.
enum class Side { kLowX, kHighX, kLowZ, kHighZ };

class Halo {
 public:
  /// `profile`: where time and messages are counted, if anywhere.
  explicit Halo(const parallel::Decomposition& decomposition, bool walls_in_x = false,
                parallel::Profile* profile = nullptr);

  /// Fills all ghost layers of the fields in x, then in z (so that corners are right), in the given rows.
  void fill(std::initializer_list<Field*> fields, RowSpan rows) {
    fill_in_x(fields, rows);
    fill_in_z(fields, rows);
  }
  /// Fills them in all rows, those beyond the walls included; the fields have equally many ghost layers.
  void fill(std::initializer_list<Field*> fields);
  /// The two halves. In z the ghost layers in x travel too: they are right before.
  void fill_in_x(std::initializer_list<Field*> fields, RowSpan rows);
  void fill_in_z(std::initializer_list<Field*> fields, RowSpan rows);
  /// Fills only the ghost layers beyond one side, beside interior cells (z sides: beside the ghost columns in
  /// x, too): half a message, for stencils that look one way.
  void fill_side(Side side, std::initializer_list<Field*> fields, RowSpan rows);

  /// True where x is periodic and whole on every rank: a ghost cell in x is then a copy from its own row,
  /// which a sweep that has the row in the cache can make itself.
  [[nodiscard]] bool wraps_in_x() const { return !walls_in_x_ && decomposition_.x_line().size() == 1; }

 private:
  void exchange(Side side, std::initializer_list<Field*> fields, RowSpan rows);
  [[nodiscard]] bool at_wall(Side side) const;
  [[nodiscard]] const parallel::Communicator& line_of(Side side) const;

  const parallel::Decomposition& decomposition_;
  const bool walls_in_x_;
  parallel::Profile* profile_;
  parallel::LineShift<Real> shift_in_x_, shift_in_z_;
};

}  // namespace softwall::grid
