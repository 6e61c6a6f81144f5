#pragma once

#include <filesystem>
#include <string_view>

namespace softwall::campaign {

/// Writes to what a user has named. A plain file, new or old, is there complete or as it was, with the
/// permissions it had; where a link is named, the file it points to. A device, a pipe or a file with several
/// names is written to and stays what it is. Throws std::system_error naming the file.
void write_output(const std::filesystem::path& file, std::string_view contents);

}  // namespace softwall::campaign
