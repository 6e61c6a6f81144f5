#pragma once

#include <string>

#include "solver/time/advance.hpp"

namespace softwall::output {

/// What a line of the log tells beside the state.
struct Progress {
  time::TimeStep last_step;
  double divergence = 0;        ///< largest in a cell, times dx / U_b
  double ns_per_cell_step = 0;  ///< of wall time
};

/// One line on where a run is; in a driven channel with the driving gradient and the friction Reynolds number
/// of the rigid wall at this moment. All ranks must ask.
[[nodiscard]] std::string progress_line(const time::State& state, const time::Setup& setup,
                                        const Progress& progress);

}  // namespace softwall::output
