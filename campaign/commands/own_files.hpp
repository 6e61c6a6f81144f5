#pragma once

#include <filesystem>
#include <string>

namespace softwall::campaign {

/// Throws BadInput when what `command` is to write would take the place of what it is made from: the
/// campaign's file, its store or its cases. campaign: file or folder, as the user named it.
void refuse_own_files(const std::string& command, const std::filesystem::path& file,
                      const std::filesystem::path& campaign);

}  // namespace softwall::campaign
