#pragma once

#include <sys/types.h>

#include <filesystem>

#include "solver/case/file_descriptor.hpp"

namespace softwall::campaign {

/// Opens a file that softwall keeps in a campaign's folder, and makes it with this mode where it is not
/// there. flags: of open(2). It is closed on exec. What is written into it must not end up behind a link, nor
/// must a pipe stop us: throws BadInput when the name stands for a link or a device, std::system_error when
/// the file cannot be opened.
[[nodiscard]] FileDescriptor open_own_file(const std::filesystem::path& file, int flags, mode_t mode);

}  // namespace softwall::campaign
