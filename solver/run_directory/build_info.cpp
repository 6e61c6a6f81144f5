#include "solver/run_directory/build_info.hpp"

#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>

#include "solver/run_directory/git_revision.hpp"

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
  using std::chrono::milliseconds;
  return utc_text(
      std::chrono::duration_cast<milliseconds>(std::chrono::system_clock::now().time_since_epoch()));
}

std::string utc_text(std::chrono::milliseconds since_1970) {
  const auto whole = std::chrono::floor<std::chrono::seconds>(since_1970);  // also before 1970
  const std::time_t seconds = whole.count();
  std::tm broken_down{};
  gmtime_r(&seconds, &broken_down);
  std::array<char, 32> text{};
  const std::size_t written = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &broken_down);
  std::snprintf(text.data() + written, text.size() - written, ".%03dZ",
                static_cast<int>((since_1970 - whole).count()));
  return text.data();
}

}  // namespace softwall
