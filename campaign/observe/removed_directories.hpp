#pragma once

#include <filesystem>
#include <vector>

/// Run directories on their way out. One is renamed first and removed then, so that what a softwall that was
/// killed meanwhile has left of it is never taken for a case, and is found again.
namespace softwall::campaign {

/// By its name: the rest of one that was to be removed.
[[nodiscard]] bool is_being_removed(const std::filesystem::path& directory);

/// All of them below `folder`, in the order of their names.
[[nodiscard]] std::vector<std::filesystem::path> unfinished_removals(const std::filesystem::path& folder);

/// Throws std::filesystem::filesystem_error when something of it stays.
void remove_run_directory(const std::filesystem::path& directory);

}  // namespace softwall::campaign
