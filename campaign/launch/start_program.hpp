#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace softwall::campaign {

/// A program that runs on its own: in a session of its own, so that neither Ctrl-C at the terminal nor the
/// terminal's end reaches it, in `folder`, with nothing to read and with all it says added to `log`; what it
/// says on standard error goes to `errors` where that is not empty. The environment gets kSessionVariable
/// besides. If this process dies, the kernel sends SIGUSR1 to the program.
struct ProgramStart {
  std::vector<std::string> arguments;  ///< the first is the program's path
  std::vector<std::string> environment;
  std::filesystem::path folder, log;
  std::filesystem::path errors = {};
};

/// Returns its process number once it has begun. Throws std::runtime_error when it cannot be executed. To be
/// called from one thread: the kernel's parent-death signal belongs to the thread that forks.
[[nodiscard]] pid_t start_program(ProgramStart start);

/// The exit status as a shell shows it: 128 + signal for a killed program.
[[nodiscard]] int exit_code_of(int wait_status);

}  // namespace softwall::campaign
