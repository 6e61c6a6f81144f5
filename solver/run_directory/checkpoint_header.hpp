#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/run_directory/checkpoint_digest.hpp"
#include "solver/run_directory/run_files.hpp"

/// A checkpoint is an HDF5 file with a user block of 4096 bytes in front: one JSON object, padded with
/// spaces, ended by a newline. The block says which case and step the file holds and carries a digest of all
/// that follows and, in "check", one of itself, so a file is accepted or refused without HDF5, whose opening
/// without an error proves nothing about the data.
namespace softwall {

struct CheckpointHeader {
  int format = 1;
  std::string case_id;
  std::int64_t step = 0;
  double time = 0.0;       ///< h/U_b
  std::int64_t bytes = 0;  ///< size of the whole file
  std::uint64_t xxh3 = 0;  ///< digest of all bytes from 4096 on: checkpoint_digest.hpp
  std::string precision = "double";
  std::array<int, 3> grid{};       ///< cells nx, ny, nz
  std::array<double, 3> length{};  ///< box, h
  std::string git_revision;
  int attempt = 0;
  int ranks = 0;
};

struct CheckpointVerdict {
  bool valid = false;
  bool unreadable =
      false;           ///< not valid only because we cannot read it: nothing is known about what it holds
  std::string reason;  ///< why not valid; empty when valid
  CheckpointHeader header;
};

/// The header is whole, but none that this program can read: another version has written it.
struct CheckpointOfAnotherVersion : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether who could not read a checkpoint for this reason knows nothing about what it holds: the system did
/// not let us read it (permissions, I/O error, no memory), or it is of another version.
[[nodiscard]] bool tells_nothing_of_contents(const std::exception& refusal);

/// Exactly kCheckpointHeaderBytes. Throws std::length_error if the text would not fit.
[[nodiscard]] std::string format_header(const CheckpointHeader& header);

/// Only the header; says nothing about the data behind it. Throws std::runtime_error with the reason;
/// std::system_error where the system did not let us read it, CheckpointOfAnotherVersion where it is of one.
[[nodiscard]] CheckpointHeader read_checkpoint_header(const std::filesystem::path& file);

/// Reads the whole file: header, size, digest, whether it is of this case and of the step that its name says.
/// Never throws for a bad file.
[[nodiscard]] CheckpointVerdict verify_checkpoint(const std::filesystem::path& file,
                                                  const std::string& case_id);

/// The checkpoints of a run directory, newest first by the step in their headers (file times prove nothing),
/// or in their names where the header is damaged. Other files are ignored; no folder means no checkpoints.
/// Throws std::system_error when the folder cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> checkpoint_ladder(const RunFiles& run);

/// Writes the header over the first 4096 bytes of an existing file (a temporary, not yet published one).
void write_header(const std::filesystem::path& file, const CheckpointHeader& header);

}  // namespace softwall
