#pragma once

#include <cstdint>
#include <string>

namespace softwall::campaign {

/// A checkpoint of a case as it was found in the run directory.
struct CheckpointRecord {
  std::string path;  ///< relative to the run directory
  std::int64_t step = 0;
  double time = 0.0;  ///< [h/U_b]
  std::int64_t bytes = 0;
  std::string digest;  ///< xxh3 of its header
  bool valid = false;
  std::string reason;  ///< why not valid
};

}  // namespace softwall::campaign
