#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace softwall {

/// No case or campaign a user writes comes near this; a wrong file (a checkpoint, /dev/zero) does.
inline constexpr std::size_t kInputFileLimit = std::size_t{16} << 20;

/// The whole text of a small regular file. Throws BadInput, in one line, for a missing or unreadable file, a
/// directory, a FIFO or a device (without blocking on it), and for one larger than `limit` bytes.
[[nodiscard]] std::string read_input_file(const std::filesystem::path& path,
                                          std::size_t limit = kInputFileLimit);

}  // namespace softwall
