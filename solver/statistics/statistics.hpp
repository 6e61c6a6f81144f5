#pragma once

#include <span>
#include <vector>

#include "solver/run_directory/block_statistics.hpp"
#include "solver/statistics/blocks.hpp"
#include "solver/statistics/sample_clock.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

/// Averages of a running simulation: what is sampled, when, and into which block of time.
namespace softwall::statistics {

/// The accumulators of one run, identical on every rank after every call. Steps that end after start_time are
/// counted: the driving gradient is integrated exactly over each of them, fields are sampled at steps that
/// interval_steps divides, each sample standing for the time since the one before.
class Statistics {
 public:
  /// Refers to `setup` for as long as it lives.
  explicit Statistics(const time::Setup& setup);

  /// To be called by all ranks after every step, of length dt, h / U_b; ghost cells filled as advance()
  /// leaves them.
  void sample_step(const time::State& state, double dt);

  /// All accumulators, exactly: what a checkpoint must hold for the statistics to continue bit for bit.
  [[nodiscard]] std::vector<double> pack() const;
  /// Continues from what pack() returned. Throws std::runtime_error when it belongs to another grid, flow or
  /// schedule of blocks, and then changes nothing.
  void unpack(std::span<const double> packed);

  /// Means of every block sampled so far, the open one included. The caller sets case_id.
  [[nodiscard]] analysis::BlockStatistics blocks() const;

 private:
  void sample_fields(const time::State& state, double weight);

  const time::Setup& setup_;
  Blocks blocks_;
  SampleClock clock_;
};

}  // namespace softwall::statistics
