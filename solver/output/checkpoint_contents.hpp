#pragma once

#include <vector>

namespace softwall::output {

/// What a checkpoint holds beside the state of the flow.
struct RunRecord {
  std::vector<double> statistics;    ///< Statistics::pack()
  double limited_cells = 0;          ///< limited or torn cells since the case began, all ranks and attempts
  double solid_volume_at_start = 0;  ///< sum of phi dV at time 0, h^3
};

}  // namespace softwall::output
