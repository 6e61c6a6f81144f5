#include "solver/parallel/profile.hpp"

#include <ctime>
#include <utility>

namespace softwall::parallel {

namespace {

double read_clock(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

void Profile::reset(bool with_processor_time) {
  records_ = {};
  with_processor_time_ = with_processor_time;
  since_ = read_clock(CLOCK_MONOTONIC);
  if (with_processor_time_) processor_since_ = read_clock(CLOCK_THREAD_CPUTIME_ID);
}

std::array<PhaseRecord, kPhases> Profile::read() {
  enter(current_);
  return records_;
}

Phase Profile::enter(Phase next) {
  PhaseRecord& record = records_[static_cast<std::size_t>(current_)];
  const double now = read_clock(CLOCK_MONOTONIC);
  record.seconds += now - std::exchange(since_, now);
  if (with_processor_time_) {
    const double processor = read_clock(CLOCK_THREAD_CPUTIME_ID);
    record.processor_seconds += processor - std::exchange(processor_since_, processor);
  }
  return std::exchange(current_, next);
}

}  // namespace softwall::parallel
