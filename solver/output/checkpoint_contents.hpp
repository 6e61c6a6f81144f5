#pragma once

#include <map>
#include <string>
#include <vector>

namespace softwall::output {

/// What a checkpoint holds beside the state of the flow.
struct CheckpointContents {
  std::vector<double> statistics;  ///< Statistics::pack()
  /// Spectra::pack(): complete on rank 0 when written, on all ranks when read. Checkpoints of earlier
  /// versions have none.
  std::map<std::string, std::vector<double>> spectra;
  double limited_cells = 0;  ///< limited or torn cells, once a step, summed since step limited_since_step
  double limited_since_step = 0;     ///< not 0: the case was begun by a version that counted otherwise
  double solid_volume_at_start = 0;  ///< sum of phi dV at time 0, h^3
};

}  // namespace softwall::output
