#include "solver/run_directory/run_files.hpp"

#include <array>
#include <cinttypes>
#include <cstdio>

namespace softwall {

std::filesystem::path RunFiles::checkpoint(std::int64_t step) const {
  std::array<char, 48> name{};
  std::snprintf(name.data(), name.size(), "checkpoint-%09" PRId64 ".h5", step);
  return checkpoints() / name.data();
}

}  // namespace softwall
