#include "campaign/observe/removed_directories.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = ".removed-";  // no label begins with a point

}  // namespace

bool is_being_removed(const fs::path& directory) {
  return directory.filename().string().starts_with(kPrefix);
}

std::vector<fs::path> unfinished_removals(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder / "cases", none))
    if (is_being_removed(entry.path())) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

void remove_run_directory(const fs::path& directory) {
  const fs::path doomed = directory.parent_path() / (std::string(kPrefix) + directory.filename().string());
  fs::remove_all(doomed);  // the case has been there before
  fs::rename(directory, doomed);
  fs::remove_all(doomed);
}

}  // namespace softwall::campaign
