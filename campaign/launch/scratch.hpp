#pragma once

#include <filesystem>

namespace softwall::campaign {

/// The folder for temporary files: absolute, and short enough for the names of sockets in it.
[[nodiscard]] std::filesystem::path temporary_root();

/// The private temporary directories that Open MPI uses for one run directory: session files and
/// shared-memory segments, which a killed mpirun leaves behind (about 10 MB each time). Their names follow
/// from the run directory alone, so that any later softwall finds and removes what a killed one left; where
/// another user has taken a name, the next of a few is used. They are short, because paths of sockets may not
/// be long.
class Scratch {
 public:
  explicit Scratch(const std::filesystem::path& run_directory);

  /// Make both, empty and readable by this user only. Throws std::runtime_error.
  void create() const;
  /// Remove both. Only when no process of the run directory is left.
  void remove() const;

  [[nodiscard]] const std::filesystem::path& session() const { return session_; }
  [[nodiscard]] const std::filesystem::path& shared_memory() const { return shared_memory_; }

 private:
  std::filesystem::path session_;
  std::filesystem::path shared_memory_;
};

}  // namespace softwall::campaign
