#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>

/// Writing files that matter: a reader, also after a crash, finds the old file or the new one, never half of
/// one. Temporary file in the same folder, fsync, rename, fsync of the folder. Errors throw std::system_error
/// naming the file and the step that failed; the temporary file is then removed and the old one is untouched.
namespace softwall {

enum class Durability {
  kSynced,  ///< survives a power loss once the call returns
  kQuick    ///< atomic for other processes, but a power loss may bring the old contents back (status.json)
};

void write_atomically(const std::filesystem::path& file, std::string_view contents,
                      Durability durability = Durability::kSynced);

/// Writes a file that must not exist yet, as write_atomically() does. Returns false, and changes nothing,
/// when the name is taken.
[[nodiscard]] bool write_new_atomically(const std::filesystem::path& file, std::string_view contents);

/// The second half of the same protocol, for a file some library wrote: fsync `temporary`, rename it to
/// `file`, fsync the folder. Both must lie in one folder.
void publish_file(const std::filesystem::path& temporary, const std::filesystem::path& file);

/// Asks the kernel to begin writing out what it holds of an open file, and does not wait: a later fsync has
/// less to wait for. No more than a hint, so that failing is no error.
void begin_write_out(int descriptor);

/// All of it, however often the system takes a part only. `path` is for the message.
void write_all(int descriptor, std::string_view contents, const std::filesystem::path& path);

/// Whether an error is one of the disk, or of what a user may write there, and so may pass: no space or quota
/// left, a limit on the size of files, an I/O error, a file system that can only be read.
[[nodiscard]] bool is_trouble_of_disk(const std::error_code& error);

/// fsync a file that somebody else has written, and its folder.
void sync_file(const std::filesystem::path& file);

/// fsync a folder, so that creations, renames and removals in it survive a power loss.
void sync_directory(const std::filesystem::path& directory);

}  // namespace softwall
