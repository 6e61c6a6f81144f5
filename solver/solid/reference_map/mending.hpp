#pragma once

#include <cstddef>
#include <vector>

#include "solver/solid/reference_map/transport.hpp"

/// Mends a map that the grid has torn. Under a surface that the grid cannot resolve (waves about to break),
/// neighbouring points lose each other: det A departs from 1 by much, or the stretch exceeds anything that
/// the layer could do. No stress brings such points together again, and left alone they end the run. So in
/// every substep a point beside such a cell moves towards the mean of its six neighbours, half the way where
/// the damage is whole. Cells whose damage is whole are torn. They are counted (`limited_cells`), and the
/// count tells how far to trust a run.
namespace softwall::solid::reference_map {

/// Damage begins where |det A - 1| or the trace of B exceeds the first of these numbers and is whole (1) at
/// the second. B of a sheared layer with du/dy = P / G at the paper's softest wall has a trace below 7.
inline constexpr Real kDamagedVolume = Real(0.35), kTornVolume = Real(0.7);
inline constexpr Real kDamagedStretch = 15, kTornStretch = 30;

/// Between 0 and 1; 0 in cells without solid.
[[gnu::always_inline]] inline Real damage_of(Real phi, Real determinant, Real trace_of_B) {
  const Real off = determinant < 1 ? 1 - determinant : determinant - 1;
  const Real volume = (off - kDamagedVolume) / (kTornVolume - kDamagedVolume),
             stretch = (trace_of_B - kDamagedStretch) / (kTornStretch - kDamagedStretch);
  const Real worse = volume > stretch ? volume : stretch, bounded = worse < 1 ? worse : Real(1);
  return phi > 0 && bounded > 0 ? bounded : Real(0);
}

/// The damage of every cell, and which rows have any: nearly always none.
class Damage {
 public:
  explicit Damage(const Grid& grid);

  /// At centers, with one column and plane more on the low sides.
  [[nodiscard]] View<Real> view() { return values_.view(); }
  [[nodiscard]] View<const Real> view() const { return values_.view(); }
  /// Row j of plane -1 <= k < nz.
  void set_row(int j, int k, bool has_any) { rows_[place(j, k)] = has_any ? 1 : 0; }
  /// Whether a point of row j, plane k lies beside a damaged cell.
  [[nodiscard]] bool touches(int j, int k) const {
    return (rows_[place(j, k)] | rows_[place(j, k - 1)] | rows_[place(j > 0 ? j - 1 : 0, k)]) != 0;
  }

 private:
  [[nodiscard]] std::size_t place(int j, int k) const {
    return static_cast<std::size_t>(k + 1) * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(j);
  }

  int ny_;
  grid::Field values_;
  std::vector<char> rows_;
};

/// Finds what moves in a plane and adds it later, when no other plane's rates read the old displacement.
class Mending {
 public:
  /// `planes`: found before the first of them is added.
  Mending(const Grid& grid, int planes);

  void find(const Damage& damage, const grid::VectorField& displacement, const RowsOfAPlane& rows);
  void add(const Damage& damage, const RowsOfAPlane& rows, grid::VectorField& displacement) const;

 private:
  const Grid& grid_;
  int planes_;
  grid::VectorField moves_;
};

}  // namespace softwall::solid::reference_map
