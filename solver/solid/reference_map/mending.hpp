#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "solver/case/elastic_law.hpp"
#include "solver/solid/reference_map/strain.hpp"
#include "solver/solid/reference_map/transport.hpp"

/// Mends a map that the grid has torn. Under a surface that the grid cannot resolve (waves about to break),
/// neighbouring points lose each other: det A departs from 1 by much, or the stretch exceeds anything that
/// the layer could do. No stress brings such points together again, and left alone they end the run. So a
/// point beside such a cell moves towards the mean of its six neighbours, where the damage is full at
/// six times the rate at which signals cross a cell (MendingRate). Cells whose damage is twice as large are
/// torn. They are counted (`limited_cells`), and the count tells how far to trust a run.
///
/// Damage begins early: on 96 x (96 + 24) x 96 cells, G = 0.25, errors of det A that were left alone until
/// they exceeded 0.35 grew within 4 h/U_b, 0.2 at t = 16 and 1 at t = 21, and the step fell to a tenth. Where
/// the grid resolves the waves, det A is within 0.1 of 1 and nothing is mended.
namespace softwall::solid::reference_map {

/// Damage is 0 where |det A - 1| and the trace of B are at most `from`, and grows by 1 with every `unit`
/// beyond. B of a sheared layer with du/dy = P / G at the paper's softest wall has a trace below 7.
struct DamageScale {
  Real from, unit;
  [[nodiscard]] constexpr Real of(Real value) const { return (value - from) / unit; }
};
inline constexpr DamageScale kVolumeDamage{Real(0.1), Real(0.3)}, kStretchDamage{10, 10};
inline constexpr Real kFullDamage = 1, kTorn = 2;

/// Between 0 and kTorn; 0 in cells without solid.
[[gnu::always_inline]] inline Real damage_of(Real phi, Real determinant, Real trace_of_B) {
  const Real off = determinant < 1 ? 1 - determinant : determinant - 1;
  const Real volume = kVolumeDamage.of(off), stretch = kStretchDamage.of(trace_of_B);
  const Real worse = volume > stretch ? volume : stretch, bounded = worse < kTorn ? worse : kTorn;
  return phi > 0 && bounded > 0 ? bounded : Real(0);
}

/// How fast a damaged cell is mended, U_b / h: six times as fast as elastic waves along x and z and the flow
/// together cross it. It is a rate, and not a share for each substep, so that a run of shorter steps is not
/// mended more; and it rises with the stretch that makes a step short, so that it does not fade just where a
/// map is about to tear (a rate that was the same everywhere did: 96 x (96 + 24) x 96 cells, G = 0.25, t =
/// 24; with three times instead of six steps fell to 0.002 there). A torn cell, whose B says nothing any more
/// (kept_share), counts as stretched by the most.
struct MendingRate {
  Real wave_x, wave_z;  ///< 4 stiffness / spacing^2 of a cell that is not stretched
  Real flow;            ///< U_b / dx
  MendingRate(const ElasticLaw<Real>& law, const Grid& grid);
  [[nodiscard]] Real of(Real B_xx, Real B_zz, Real damage) const {
    constexpr Real kHaste = 6;
    const Real least = kLargestStretch * (damage - kFullDamage) / (kTorn - kFullDamage);
    return kHaste * (std::sqrt(wave_x * std::max(B_xx, least) + wave_z * std::max(B_zz, least)) + flow);
  }
};

/// The damage of every cell, and which rows have any: nearly always none.
class Damage {
 public:
  Damage(const ElasticLaw<Real>& law, const Grid& grid);

  /// At centers, with one column and plane more on the low sides. Where a row is finished (`finish_row`) it
  /// holds the damage, at most kFullDamage, times the rate of mending.
  [[nodiscard]] View<Real> view() { return values_.view(); }
  [[nodiscard]] View<const Real> view() const { return values_.view(); }
  /// Row j of plane -1 <= k < nz, from column -1 on. Returns the number of its torn cells from column 0 on.
  int finish_row(int j, int k, const View<Real>& B_xx, const View<Real>& B_zz);
  /// Whether a point of row j, plane k lies beside a damaged cell.
  [[nodiscard]] bool touches(int j, int k) const {
    return (rows_[place(j, k)] | rows_[place(j, k - 1)] | rows_[place(j > 0 ? j - 1 : 0, k)]) != 0;
  }

 private:
  [[nodiscard]] std::size_t place(int j, int k) const {
    return static_cast<std::size_t>(k + 1) * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(j);
  }

  int nx_, ny_;
  MendingRate rate_;
  grid::Field values_;
  std::vector<char> rows_;
};

/// Finds what moves in a plane and adds it later, when no other plane's rates read the old displacement.
class Mending {
 public:
  /// `planes`: found before the first of them is added.
  Mending(const Grid& grid, int planes);

  /// duration: of the substep.
  void find(const Damage& damage, const grid::VectorField& displacement, const RowsOfAPlane& rows,
            double duration);
  void add(const Damage& damage, const RowsOfAPlane& rows, grid::VectorField& displacement) const;

 private:
  const Grid& grid_;
  int planes_;
  grid::VectorField moves_;
};

}  // namespace softwall::solid::reference_map
