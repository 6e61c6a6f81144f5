#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

#include "solver/case/file_descriptor.hpp"

namespace softwall::campaign {

/// What the user sees while a campaign runs, on standard error: events, one line each, and below them, only
/// on a terminal, one line that is redrawn. Events also go to manager.log in the campaign's folder.
class Progress {
 public:
  enum class Kind { kPlain, kGood, kBad };

  /// log may be empty: then none is kept, nor where it cannot be opened. Throws BadInput when its name stands
  /// for something else than a file.
  explicit Progress(const std::filesystem::path& log);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void event(const std::string& what, Kind kind = Kind::kPlain);
  /// Redraw the line; nothing happens where standard error is not a terminal.
  void draw(const std::string& line);
  [[nodiscard]] bool on_terminal() const { return terminal_; }

 private:
  void erase();

  FileDescriptor log_;
  bool terminal_ = false;
  bool colours_ = false;
  bool drawn_ = false;
  std::string line_;
};

}  // namespace softwall::campaign
