#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "solver/statistics/packed_reader.hpp"

namespace softwall::statistics {

/// Which steps count, and for how much time a sample stands: for that since the one before, or since the
/// first moment that counts. Times in h / U_b.
class SampleClock {
 public:
  /// Returns how much of a step of length dt that ends at `time` lies after `start`; 0: the step does not
  /// count.
  double counted(double time, double dt, double start) {
    const double begin = std::max(time - dt, start);
    if (!(time > begin)) return 0;
    if (!started_) last_sample_ = begin;
    started_ = true;
    return time - begin;
  }
  /// A sample is taken: returns the time that it stands for.
  double take(double time) { return time - std::exchange(last_sample_, time); }
  /// The next sample stands for the time from the next step that counts on.
  void pause() { started_ = false; }
  /// Time up to which samples stand for the flow.
  [[nodiscard]] double last_sample() const { return last_sample_; }

  /// Exactly, for a checkpoint, and back. unpack throws std::runtime_error when numbers are missing.
  [[nodiscard]] std::array<double, 2> pack() const { return {started_ ? 1.0 : 0.0, last_sample_}; }
  void unpack(std::span<const double> packed) {
    PackedReader reader(packed);
    started_ = reader.number() != 0;
    last_sample_ = reader.number();
  }

 private:
  bool started_ = false;
  double last_sample_ = 0;
};

}  // namespace softwall::statistics
