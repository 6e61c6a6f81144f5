#pragma once

#include <vector>

#include "solver/parallel/mpi.hpp"

/// How the box is shared: columns that are whole in y, split in x (px parts) and z (pz parts).
///
///      z ^   +-----+-----+        Every rank holds the full height of its columns, so each has the
///        |   | 0,1 | 1,1 |        same share of fluid and of solid.  Few ranks: px = 1 (slabs in z,
///        |   +-----+-----+        two transposes a Poisson solve); many: both directions (six).
///        |   | 0,0 | 1,0 |
///        +---+-----+-----+---> x
namespace softwall::parallel {

/// Half-open interval of global indices.
struct Range {
  int begin = 0, end = 0;
  [[nodiscard]] int size() const { return end - begin; }
};

/// Part `index` of n items shared as evenly as possible; earlier parts are at most one item larger.
[[nodiscard]] Range share(int n, int parts, int index);

/// All parts of n items.
[[nodiscard]] std::vector<Range> shares(int n, int parts);

class Decomposition {
 public:
  /// The narrowest part a rank may hold: WENO reads three neighbours on either side.
  static constexpr int kMinimumWidth = 3;

  /// Shares nx x nz columns among the ranks of `comm`.
  /// Throws std::invalid_argument when there are more ranks than the grid can feed.
  Decomposition(MPI_Comm comm, int nx, int nz);

  [[nodiscard]] const Communicator& all() const { return all_; }
  [[nodiscard]] const Communicator& x_line() const { return x_line_; }  ///< ranks that differ in x only
  [[nodiscard]] const Communicator& z_line() const { return z_line_; }  ///< ranks that differ in z only
  [[nodiscard]] int px() const { return px_; }
  [[nodiscard]] int pz() const { return pz_; }
  [[nodiscard]] Range x() const { return x_; }  ///< this rank's columns
  [[nodiscard]] Range z() const { return z_; }

 private:
  int px_ = 1, pz_ = 1;
  Communicator all_, x_line_, z_line_;
  Range x_, z_;
};

}  // namespace softwall::parallel
