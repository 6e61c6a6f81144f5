#include "campaign/runner/progress.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <system_error>

#include "campaign/store/text_width.hpp"
#include "campaign/system/clock.hpp"
#include "campaign/system/own_file.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {
namespace {

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// Cut to a number of characters on the screen, counting each UTF-8 character as one.
std::string cut(const std::string& text, std::size_t characters) {
  std::size_t seen = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts_character = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (starts_character && seen++ == characters) return text.substr(0, i);
  }
  return text;
}

const char* colour_of(Progress::Kind kind) {
  switch (kind) {
    case Progress::Kind::kGood:
      return "\033[32m";
    case Progress::Kind::kBad:
      return "\033[31m";
    case Progress::Kind::kPlain:
      break;
  }
  return "";
}

bool wants_colours(bool terminal) {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* kind = std::getenv("TERM");
  return terminal && (no_colour == nullptr || *no_colour == '\0') && kind != nullptr &&
         std::string(kind) != "dumb";
}

/// A campaign on a disk without room for a log runs without one.
FileDescriptor opened_if_possible(const std::filesystem::path& log) {
  constexpr mode_t kForAllToRead = S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH;
  try {
    return open_own_file(log, O_WRONLY | O_APPEND, kForAllToRead);
  } catch (const std::system_error&) {
    return FileDescriptor();
  }
}

/// What a full disk does not take is lost; later lines may have room again.
void append(int file, const std::string& text) {
  try {
    write_all(file, text, "manager.log");
  } catch (const std::system_error&) {
  }
}

}  // namespace

Progress::Progress(const std::filesystem::path& log)
    : terminal_(isatty(STDERR_FILENO) == 1), colours_(wants_colours(terminal_)) {
  if (!log.empty()) log_ = opened_if_possible(log);
}

Progress::~Progress() { erase(); }

void Progress::event(const std::string& what, Kind kind) {
  const std::string text = printable(what);  // names may hold anything: one event, one harmless line
  erase();
  const char* colour = colours_ ? colour_of(kind) : "";
  std::fprintf(stderr, "%s  %s%s%s\n", local_time_of_day().c_str(), colour, text.c_str(),
               *colour != '\0' ? "\033[0m" : "");
  std::fflush(stderr);
  if (log_) append(log_.get(), utc_now() + "  " + text + "\n");
  if (!line_.empty()) draw(line_);
}

void Progress::draw(const std::string& line) {
  if (!terminal_) return;
  line_ = line;
  std::fprintf(stderr, "\r\033[K%s", cut(printable(line), terminal_width() - 1).c_str());
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::erase() {
  if (!drawn_) return;
  std::fprintf(stderr, "\r\033[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace softwall::campaign
