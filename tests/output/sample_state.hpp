#pragma once

#include <string>
#include <vector>

#include "solver/output/checkpoint_writer.hpp"
#include "solver/time/initial.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"

namespace softwall::support {

inline constexpr const char* kCaseId = "0123456789abcdef";

/// A state whose every number is different and known from its indices alone.
inline time::State numbered_state(const time::Setup& setup, std::int64_t step) {
  time::State state = time::state_at_rest(setup);
  int seed = 1;
  for (const time::NamedField& f : time::fields_of(state)) {
    ++seed;
    set_by_index(*f.field, setup.grid, f.rows, [=](int i, int j, int k) { return noise(seed, i, j, k); });
  }
  state.step = step;
  state.time = 0.1 * static_cast<double>(step) + 1e-17;
  state.driving_gradient = 1.0 / 3.0;
  return state;
}

inline output::CheckpointContents sample_record() {
  return {.statistics = {1.0, 0.1, -1e-300, 1e300},
          .spectra = {},
          .limited_cells = 17,
          .limited_since_step = 3,
          .solid_volume_at_start = 2.25};
}

/// All fields of a state, gathered on every rank.
inline std::vector<std::vector<double>> all_fields(time::State& state, const time::Setup& setup) {
  std::vector<std::vector<double>> values;
  for (const time::NamedField& f : time::fields_of(state)) {
    values.push_back(global_values(*f.field, setup.grid, f.rows, setup.decomposition.all()));
  }
  return values;
}

}  // namespace softwall::support
