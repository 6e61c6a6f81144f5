#include "solver/run_directory/run_files.hpp"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <string>

namespace softwall {
namespace {

/// -000001234.h5: names sort as the steps do.
std::string ending_of(std::int64_t step) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "-%09" PRId64 ".h5", step);
  return text.data();
}

}  // namespace

std::filesystem::path RunFiles::checkpoint(std::int64_t step) const {
  return checkpoints() / ("checkpoint" + ending_of(step));
}

std::filesystem::path RunFiles::fields_of(std::int64_t step) const {
  return fields() / ("fields" + ending_of(step));
}

std::filesystem::path RunFiles::planes_of(std::int64_t step) const {
  return planes() / ("planes" + ending_of(step));
}

}  // namespace softwall
