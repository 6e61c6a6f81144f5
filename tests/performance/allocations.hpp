#pragma once

#include <cstdint>

namespace softwall::support {

/// How often this program has called operator new; MPI and FFTW, written in C, go other ways.
[[nodiscard]] std::int64_t allocations();

}  // namespace softwall::support
