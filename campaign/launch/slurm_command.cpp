#include "campaign/launch/slurm_command.hpp"

#include <unistd.h>

#include <utility>

#include "campaign/launch/launch_environment.hpp"
#include "campaign/system/find_program.hpp"

namespace softwall::campaign {

Answer ask_slurm(const std::string& program, std::vector<std::string> arguments, double seconds) {
  const auto file = find_on_path(program);
  if (!file) return {"", program + " is not on the PATH", std::nullopt};
  arguments.insert(arguments.begin(), *file);
  return ask_program({std::move(arguments), scheduler_environment(own_environment()), seconds});
}

std::string of_this_user() { return "--user=" + std::to_string(geteuid()); }

std::string in_one_line(const std::string& text) {
  constexpr std::size_t kLongest = 300;
  std::string line;
  for (const char c : text.substr(0, kLongest)) line += c == '\n' || c == '\r' ? ' ' : c;
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

std::string trouble_in(const Answer& answer, const std::string& program) {
  const std::string words = in_one_line(answer.errors);
  if (!words.empty()) return words;
  return program +
         (answer.exit_code ? ": exit status " + std::to_string(*answer.exit_code) : " does not answer");
}

}  // namespace softwall::campaign
