#pragma once

#include <optional>
#include <vector>

#include "solver/parallel/mpi.hpp"

/// How the box is shared: columns that are whole in y, split in x (px parts) and z (pz parts).
///
///      z ^   +-----+-----+        Every rank holds the full height of its columns, so each has the
///        |   | 0,1 | 1,1 |        same share of fluid and of solid.  Few ranks: px = 1 (slabs in z,
///        |   +-----+-----+        two transposes a Poisson solve); many: both directions (six).
///        |   | 0,0 | 1,0 |
///        +---+-----+-----+---> x
/// Where "few" ends depends on the machine: time/fastest_layout.hpp measures it.
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

/// Number of parts into which x and z are divided; px * pz ranks share them.
struct Layout {
  int px = 1, pz = 1;
  friend bool operator==(const Layout&, const Layout&) = default;
};

/// All layouts of nx x nz columns whose parts are wide enough, those with the fewest parts in x (thus the
/// fewest transposes) first. Empty when there are more ranks than the grid can feed.
[[nodiscard]] std::vector<Layout> possible_layouts(int ranks, int nx, int nz);

class Decomposition {
 public:
  /// The narrowest part of a direction that is shared: WENO reads three neighbours on either side. (A
  /// direction that is whole on every rank may be narrower, down to one column: it is its own neighbour.)
  static constexpr int kMinimumWidth = 3;

  /// Shares nx x nz columns among the ranks of `comm`, by the first possible layout unless one is given.
  /// Throws std::invalid_argument when there are more ranks than the grid can feed, or when the given layout
  /// is not possible.
  Decomposition(MPI_Comm comm, int nx, int nz, std::optional<Layout> layout = std::nullopt);

  [[nodiscard]] const Communicator& all() const { return all_; }
  [[nodiscard]] const Communicator& x_line() const { return x_line_; }  ///< ranks that differ in x only
  [[nodiscard]] const Communicator& z_line() const { return z_line_; }  ///< ranks that differ in z only
  [[nodiscard]] int px() const { return layout_.px; }
  [[nodiscard]] int pz() const { return layout_.pz; }
  [[nodiscard]] Range x() const { return x_; }  ///< this rank's columns
  [[nodiscard]] Range z() const { return z_; }

 private:
  Layout layout_;
  Communicator all_, x_line_, z_line_;
  Range x_, z_;
};

}  // namespace softwall::parallel
