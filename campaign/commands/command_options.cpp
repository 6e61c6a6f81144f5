#include "campaign/commands/command_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "solver/case/bad_input.hpp"
#include "solver/case/spelling.hpp"

namespace softwall::campaign {

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> options = command.get_options();
  for (const CLI::App* group : command.get_subcommands([](const CLI::App*) { return true; })) {
    const auto more = group->get_options();
    options.insert(options.end(), more.begin(), more.end());
  }
  return options;
}

std::vector<CommandWords> words_of_commands(const CLI::App& app) {
  std::vector<CommandWords> all;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    CommandWords words{command->get_name(), command->get_description(), {}};
    for (const CLI::Option* option : options_of(*command)) {
      for (const std::string& name : option->get_lnames())
        words.options.push_back(
            {"--" + name, option->get_description(), option->get_items_expected_max() > 0});
    }
    all.push_back(std::move(words));
  }
  return all;
}

void refuse_unknown_command(const std::string& word, const std::vector<std::string>& known) {
  if (std::ranges::find(known, word) != known.end()) return;
  const auto near = suggestion(word, known);
  throw BadInput("softwall", {{"", "no command " + printable_excerpt(word),
                               near ? "did you mean " + *near + "?" : "softwall --help lists all commands"}});
}

std::string option_probably_meant(const std::vector<std::string>& words, const CLI::App& command) {
  std::vector<std::string> known;
  for (const CLI::Option* option : options_of(command)) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  for (const std::string& word : words) {
    if (!word.starts_with("--") || std::ranges::find(known, word) != known.end()) continue;
    if (const auto near = suggestion(word, known)) return "Did you mean " + *near + "?";
  }
  return "";
}

}  // namespace softwall::campaign
