#pragma once

#include "campaign/commands/exit_status.hpp"

/// What can be typed behind "softwall": commands, their options, help and completion.
namespace softwall::campaign {

/// Whether errors are to be told as JSON, too.
[[nodiscard]] bool wants_json(int count, char** words);

/// Reads the command line and runs its command. Throws BadInput for a command that does not exist, and what
/// the command throws.
[[nodiscard]] ExitStatus run_command_line(int count, char** words);

}  // namespace softwall::campaign
