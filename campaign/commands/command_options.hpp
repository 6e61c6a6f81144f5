#pragma once

#include <string>
#include <vector>

#include "campaign/commands/completion.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// The words that a command line may have, and what was probably meant by one that is none of them.
namespace softwall::campaign {

/// Those of a command and of its groups, which CLI11 keeps as commands without a name.
[[nodiscard]] std::vector<const CLI::Option*> options_of(const CLI::App& command);

/// Every command, with the long names of its options.
[[nodiscard]] std::vector<CommandWords> words_of_commands(const CLI::App& app);

/// "softwall stauts": throws BadInput, with the known command that is nearest.
void refuse_unknown_command(const std::string& word, const std::vector<std::string>& known);

/// "softwall plan --jsno DIR": "Did you mean --json?"; empty when nothing comes near.
[[nodiscard]] std::string option_probably_meant(const std::vector<std::string>& words,
                                                const CLI::App& command);

}  // namespace softwall::campaign
