#pragma once

#include <cstdint>

#include "solver/parallel/line_memory.hpp"
#include "solver/solid/formulation.hpp"
#include "solver/solid/reference_map/mending.hpp"
#include "solver/solid/reference_map/strain.hpp"
#include "solver/solid/reference_map/volume.hpp"

/// B of strain.hpp and the error of volume of volume.hpp in a whole band of rows, with the gradients that
/// neighbouring places share averaged once. Each gradient has a place of its own and is wanted at three
/// others, as a mean over two directions. Of those that are averaged over y, the mean over the other
/// direction is kept for a row of cells, or of y faces, until the next row above: so everything read again is
/// in a core's own cache.
namespace softwall::solid::reference_map {

using grid::Grid;

/// Where a sweep writes: components of B where they live, the error of volume at centers.
struct StrainFields {
  View<Real> xx, yy, zz, xy, xz, yz, volume_error;
};

class StrainSweep {
 public:
  explicit StrainSweep(const Grid& grid);

  /// Rows first_row <= j < ny, xy and yz edges on the upper wall, too; and what borders on this rank's cells:
  /// centers one column and plane before them, edges on their high sides. Returns the number of this rank's
  /// torn cells. A plane is ready for the follower when the next one is found, too.
  std::int64_t run(const Strain& strain, View<const Real> phi, int first_row, const StrainFields& to,
                   Damage& damage, PlaneFollower& follower);

 private:
  using Row = parallel::LineVector<Real>;
  /// Means of a row of cells: over x to the planes of xy edges, and over z to those of yz edges.
  struct CellRow {
    struct Means {
      Row xx, yy, zz, xz, zx;
    } to_xy, to_yz;
  };
  /// Half the means of a row of y faces over x and z, to centers and to xz edges.
  struct FaceRow {
    struct Halves {
      Row xy, yx, yz, zy;
    } to_center, to_xz;
  };

  void average(CellRow& row, const Strain& strain, int j, int k) const;
  void average(FaceRow& row, const Strain& strain, int j, int k) const;
  void centers(const Strain& strain, View<const Real> phi, int j, int k, const StrainFields& to,
               Damage& damage);
  void edges_xz(const Strain& strain, int j, int k, View<Real> to) const;
  void edges_xy(const Strain& strain, int j, int k, View<Real> to) const;
  void edges_yz(const Strain& strain, int j, int k, View<Real> to) const;

  int nx_, ny_, nz_;
  CellRow below_, above_;  ///< the face whose edges are found next
  FaceRow low_, high_;     ///< sides of the row of cells that is found next
};

}  // namespace softwall::solid::reference_map
