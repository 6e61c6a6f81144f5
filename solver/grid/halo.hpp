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

class Halo {
 public:
  explicit Halo(const parallel::Decomposition& decomposition);

  /// Fills all ghost layers of the fields in x, then in z (so that corners are right), in the given rows.
  void fill(std::initializer_list<Field*> fields, RowSpan rows);
  /// The same in all rows, those beyond the walls included; the fields have equally many ghost layers.
  void fill(std::initializer_list<Field*> fields);

 private:
  struct Shift;
  void shift(const Shift& s, std::initializer_list<Field*> fields, RowSpan rows);

  const parallel::Decomposition& decomposition_;
  std::vector<Real> send_, receive_;
};

}  // namespace softwall::grid
