#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace softwall::campaign {

/// Whether a file is there that this user may execute.
[[nodiscard]] bool is_program(const std::filesystem::path& file);

/// What PATH means where it is not set.
inline constexpr const char* kUsualPath = "/usr/local/bin:/usr/bin:/bin";

/// The first program of this name in the folders of PATH, absolute.
[[nodiscard]] std::optional<std::filesystem::path> find_on_path(const std::string& name);

}  // namespace softwall::campaign
