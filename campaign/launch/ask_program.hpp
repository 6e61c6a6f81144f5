#pragma once

#include <optional>
#include <string>
#include <vector>

namespace softwall::campaign {

/// What a program said and how it ended.
struct Answer {
  std::string output, errors;    ///< what it wrote on standard output and standard error
  std::optional<int> exit_code;  ///< as a shell shows it; empty: it did not end in time, or never began
};

/// A program that is asked something.
struct Question {
  std::vector<std::string> arguments;  ///< the first is the program's path
  std::vector<std::string> environment;
  double seconds = 0.0;  ///< it is killed if it takes longer
};

/// Runs a program to its end, with nothing to read. Throws nothing: a program that cannot be started gives an
/// answer without an exit status, whose errors say why.
[[nodiscard]] Answer ask_program(const Question& question);

}  // namespace softwall::campaign
