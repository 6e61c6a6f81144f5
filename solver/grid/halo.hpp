#pragma once

#include <initializer_list>
#include <vector>

#include "solver/grid/cell_loop.hpp"
#include "solver/grid/field.hpp"
#include "solver/parallel/decomposition.hpp"

/// Ghost layers in the periodic directions x and z, filled from the neighbouring ranks (or from the rank
/// itself). Rows beyond the walls are not touched here: they follow from boundary conditions, row by row.
namespace softwall::grid {

/// Rows to exchange: j0 <= j < j1, ghost rows included where wanted.
struct RowSpan {
  int j0 = 0, j1 = 0;
};

/// One side of every rank's box.
enum class Side { kLowX, kHighX, kLowZ, kHighZ };

class Halo {
 public:
  explicit Halo(const parallel::Decomposition& decomposition);

  /// Fills all ghost layers of the fields in x, then in z (so that corners are right), in the given rows.
  void fill(std::initializer_list<Field*> fields, RowSpan rows);
  /// The same in all rows, those beyond the walls included; the fields have equally many ghost layers.
  void fill(std::initializer_list<Field*> fields);
  /// Fills only the ghost layers beyond one side, beside interior cells (z sides: beside the ghost columns in
  /// x, too): half a message, for stencils that look one way.
  void fill_side(Side side, std::initializer_list<Field*> fields, RowSpan rows);

 private:
  const parallel::Decomposition& decomposition_;
  std::vector<Real> send_, receive_;
};

}  // namespace softwall::grid
