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
  std::istringstream folders(path != nullptr && *path != '\0' ? path : kUsualPath);
  std::error_code no_current_folder;  // it may have been deleted; absolute folders are searched all the same
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto file = std::filesystem::absolute(std::filesystem::path(folder) / name, no_current_folder);
    if (is_program(file)) return file;
  }
  return std::nullopt;
}

}  // namespace softwall::campaign
