#include "campaign/system/find_program.hpp"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

namespace softwall::campaign {

bool is_program(const std::filesystem::path& file) {
  std::error_code unreadable;
  return std::filesystem::is_regular_file(file, unreadable) && access(file.c_str(), X_OK) == 0;
}

std::optional<std::filesystem::path> find_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto file = std::filesystem::absolute(std::filesystem::path(folder) / name);
    if (is_program(file)) return file;
  }
  return std::nullopt;
}

}  // namespace softwall::campaign
