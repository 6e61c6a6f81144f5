#include "solver/case/build_info.hpp"

#include <unistd.h>

#include <array>
#include <ctime>

#include "solver/case/git_revision.hpp"

namespace softwall {

BuildInfo build_info() {
  return {SOFTWALL_VERSION, SOFTWALL_GIT_REVISION, SOFTWALL_BUILD_TYPE, SOFTWALL_COMPILER};
}

std::string host_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  return name.data();
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm broken_down{};
  gmtime_r(&now, &broken_down);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &broken_down);
  return text.data();
}

}  // namespace softwall
