#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

/// What the solver has averaged so far, block by block; statistics.h5 holds it. Every number is the
/// time-weighted MEAN over its block; a block that is still being filled is stored like the others, its
/// weight says how much of it has been sampled. Units: half height h, bulk velocity U_b, density rho.
///
/// All that statistics.h5 and spectra.h5 are made of is named as analysis/ names it, which they are written
/// for; it stands in this room because the solver, which knows nothing of analysis/, writes it.
namespace softwall::analysis {

enum class Location { kCenter, kFace };  ///< y_center (ny values) or y_face (ny + 1 values, walls included)

/// Plane means (over x and z), one profile a block.
struct Profile {
  Location location = Location::kCenter;
  std::vector<double> values;  ///< [block][y], row major
};

struct Meaning {
  std::string unit;  ///< in h, U_b, rho; "1" when dimensionless
  std::string description;
};

struct BlockStatistics {
  std::string case_id;  ///< the case these numbers belong to; may be empty in tests
  double reynolds = 0.0;
  bool elastic = false;
  double interface_y = 2.0;              ///< y of the upper wall of the fluid: flat interface, or rigid wall
  std::vector<double> y_center, y_face;  ///< strictly increasing, y_face[0] = 0, over fluid and solid
  std::vector<double> start, end,
      weight;  ///< per block: times of its two ends, and the time sampled in between
  std::map<std::string, Profile> profiles;
  std::map<std::string, std::vector<double>> series;  ///< one value a block
  /// Unit and description of names that solver/run_directory/quantities.hpp does not know; known names need
  /// none here.
  std::map<std::string, Meaning> meanings;

  [[nodiscard]] std::size_t blocks() const { return start.size(); }
  [[nodiscard]] std::size_t points(Location location) const {
    return location == Location::kCenter ? y_center.size() : y_face.size();
  }
};

}  // namespace softwall::analysis
