#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/run_directory/array_file.hpp"
#include "solver/statistics/energy_budget.hpp"
#include "solver/statistics/flow_spectra.hpp"
#include "solver/statistics/interface_modes.hpp"
#include "solver/statistics/merging_blocks.hpp"
#include "solver/statistics/sample_clock.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

/// Statistics that take more work or room than profiles do, and so are sampled more rarely and kept in a few
/// long blocks: spectra of the flow, the budget of its energy, moments, distribution and joint
/// distributions of the interface, and its waves in time. Of channels; a closed box has none. Like Statistics
/// it samples steps that end after start_time, and continues bit for bit from what it packed.
class Spectra {
 public:
  /// Samples at steps that `interval_steps` divides; 0: never, but what was sampled before is kept. Refers to
  /// `setup` for as long as it lives, and uses its transforms. Collective.
  Spectra(time::Setup& setup, std::int64_t interval_steps);

  /// To be called by all ranks after every step, of length dt, h / U_b; ghost cells filled as advance()
  /// leaves them.
  void sample_step(const time::State& state, double dt);

  /// Sums by name, complete on rank 0. Collective.
  using Packed = std::map<std::string, std::vector<double>>;
  [[nodiscard]] Packed pack() const;
  /// Continues from what pack() returned, which every rank has. What is missing begins anew. Throws
  /// std::runtime_error when it belongs to another grid or schedule of blocks.
  void unpack(const Packed& packed);

  /// Means of every block and the waves so far, as spectra.h5 holds them, on rank 0; empty elsewhere, and
  /// where there are none. Collective.
  [[nodiscard]] std::vector<analysis::NamedArray> arrays() const;

 private:
  void sample_fields(const time::State& state, double weight, const std::vector<double>& heights);

  time::Setup& setup_;
  std::int64_t interval_steps_;
  std::optional<FlowSpectra> flow_;
  std::optional<EnergyBudget> budget_;
  std::optional<MergingBlocks> of_flow_, of_budget_, of_interface_, of_pairs_;
  std::optional<InterfaceModes> waves_;
  SampleClock clock_;
  Packed on_hold_;  ///< where nothing is sampled: what earlier runs have
};

}  // namespace softwall::statistics
