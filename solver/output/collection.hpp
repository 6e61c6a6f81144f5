#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace softwall::output {

/// A file that ParaView opens as one series in time, <name>.xdmf beside the files <name>-<step>.h5 of its
/// moments. The first moment of an attempt makes it anew of all that lie in the folder, so that it is right
/// after a resume and with files of earlier versions; each later one is written behind the others, so that a
/// moment costs the same however many there are. On one rank.
class Collection {
 public:
  /// The text of one moment in XDMF, asked of its file. Throws std::runtime_error where that cannot be read.
  using Describe = std::string (*)(const std::filesystem::path& moment);

  Collection(std::filesystem::path file, Describe describe) : file_(std::move(file)), describe_(describe) {}

  /// Takes up a moment whose file has been written. Throws std::system_error when the collection cannot be
  /// written, std::runtime_error when the moment cannot be read.
  void add(const std::filesystem::path& moment);

  /// Removes the moments later than this one, which need not exist: an attempt that got further was lost with
  /// the end of its trajectory, and the one that goes on writes its own, on other ranks at other steps.
  /// Throws std::system_error.
  void remove_later_than(const std::filesystem::path& moment);

 private:
  void write_anew();
  void append(const std::string& text);

  std::filesystem::path file_;
  Describe describe_;
  std::map<std::string, std::size_t> known_;  ///< hash of what was written of each moment, by its file's name
  std::uintmax_t bytes_ = 0;                  ///< of the collection as it was left
};

}  // namespace softwall::output
