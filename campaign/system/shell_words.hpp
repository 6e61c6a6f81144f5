#pragma once

#include <filesystem>
#include <string>

namespace softwall::campaign {

/// A text as one word of a command that people copy into their shell (bash): as it is where that is plain,
/// else in single quotes; with control characters in $'...', so that a terminal shows the command that it
/// takes.
[[nodiscard]] std::string shell_word(const std::string& text);

/// A text as one word in a script: read as the same text by every POSIX sh, whatever is in it. ($'...' is
/// known to bash, not to dash.)
[[nodiscard]] std::string script_word(const std::string& text);

/// "softwall resume '/data/soft walls'": what a user may copy and run.
[[nodiscard]] std::string softwall_command(const std::string& command, const std::filesystem::path& path);

}  // namespace softwall::campaign
