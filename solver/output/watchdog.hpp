#pragma once

#include <cstdint>

namespace softwall::output {

/// Ends the process with exit code 75 if its scope takes longer than it should. After an I/O error on one
/// rank the others can hang inside a collective call; no agreement helps there, only a clock does.
/// mpirun then ends the other ranks. One at a time (it uses alarm()).
class Watchdog {
 public:
  explicit Watchdog(unsigned seconds);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Generous for writing or reading so many bytes: two minutes, and 5 MB/s.
  [[nodiscard]] static unsigned seconds_for(std::int64_t bytes);
};

}  // namespace softwall::output
