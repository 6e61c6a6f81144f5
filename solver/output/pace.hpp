#pragma once

#include <chrono>
#include <cstdint>

namespace softwall::output {

using Clock = std::chrono::steady_clock;

/// True once in every period, starting one period after construction or the last reset().
class Timer {
 public:
  explicit Timer(double seconds) : period_(seconds), last_(Clock::now()) {}
  [[nodiscard]] bool due() const { return seconds_since(last_) >= period_; }
  void reset() { last_ = Clock::now(); }
  [[nodiscard]] static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

 private:
  double period_;
  Clock::time_point last_;
};

/// How long steps take, by the wall clock. Checkpoints and the like are not counted.
class Pace {
 public:
  void begin_step() { begin_ = Clock::now(); }
  void end_step() {
    const double seconds = Timer::seconds_since(begin_);
    total_ += seconds;
    recent_ = steps_++ == 0 ? seconds : recent_ + kNewShare * (seconds - recent_);
  }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  /// Recent steps weigh most, s.
  [[nodiscard]] double seconds_per_step() const { return recent_; }
  /// Mean of this attempt, ns.
  [[nodiscard]] double ns_per_cell_step(double cells) const {
    return steps_ > 0 ? 1e9 * total_ / (static_cast<double>(steps_) * cells) : 0.0;
  }

 private:
  static constexpr double kNewShare = 0.1;
  Clock::time_point begin_;
  double total_ = 0, recent_ = 0;
  std::int64_t steps_ = 0;
};

}  // namespace softwall::output
