#include "campaign/launch/solver_log.hpp"

#include <cstdint>
#include <system_error>

namespace softwall::campaign {
namespace {

bool is_too_large(const std::filesystem::path& log) {
  constexpr std::uintmax_t kLargest = 16U << 20U;
  std::error_code none;
  const auto size = std::filesystem::file_size(log, none);
  return !none && size > kLargest;
}

}  // namespace

void keep_small(const std::filesystem::path& log) {
  std::error_code none;
  if (is_too_large(log)) std::filesystem::rename(log, log.string() + ".old", none);
}

void keep_small_while_written(const std::filesystem::path& log) {
  if (!is_too_large(log)) return;
  std::error_code none;
  std::filesystem::copy_file(log, log.string() + ".old", std::filesystem::copy_options::overwrite_existing,
                             none);
  std::filesystem::resize_file(log, 0, none);
}

}  // namespace softwall::campaign
