#include "campaign/commands/completion.hpp"

#include <sstream>

namespace softwall::campaign {
namespace {

/// In single quotes, as all three shells read them: a quote inside ends the text, stands by itself, and
/// begins it again.
std::string quoted_word(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// zsh ends the name of a word at ':' and the explanation of an option at ']'.
std::string escaped(const std::string& text, const std::string& special) {
  std::string escaped;
  for (const char c : text)
    escaped += special.find(c) == std::string::npos ? std::string(1, c) : std::string{'\\', c};
  return escaped;
}

std::string names_of(const std::vector<CommandWords>& commands) {
  std::string names;
  for (const auto& command : commands) names += (names.empty() ? "" : " ") + command.name;
  return names;
}

std::string names_of(const std::vector<OptionWords>& options) {
  std::string names;
  for (const auto& option : options) names += (names.empty() ? "" : " ") + option.name;
  return names;
}

/// Everything but commands and options is a file, which bash completes by itself.
std::string for_bash(const std::vector<CommandWords>& commands) {
  std::ostringstream out;
  out << "_softwall() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  COMPREPLY=()\n"
         "  if ((COMP_CWORD == 1)) || [[ ${COMP_WORDS[1]} == help ]]; then\n"
         "    words="
      << quoted_word(names_of(commands))
      << "\n"
         "  elif [[ $word == -* ]]; then\n"
         "    case ${COMP_WORDS[1]} in\n";
  for (const auto& command : commands)
    out << "      " << command.name << ") words=" << quoted_word(names_of(command.options)) << " ;;\n";
  out << "    esac\n"
         "  fi\n"
         "  if [[ -n $words ]]; then COMPREPLY=($(compgen -W \"$words\" -- \"$word\")); fi\n"
         "}\n"
         "complete -o default -F _softwall softwall\n";
  return out.str();
}

std::string for_zsh(const std::vector<CommandWords>& commands) {
  std::ostringstream out;
  out << "#compdef softwall\n"
         "_softwall() {\n"
         "  local -a commands\n"
         "  commands=(\n";
  for (const auto& command : commands)
    out << "    " << quoted_word(command.name + ":" + escaped(command.help, ":\\")) << "\n";
  out << "  )\n"
         "  if ((CURRENT == 2)) || [[ $words[2] == help ]]; then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  local command=$words[2]\n"
         "  shift words\n"
         "  ((CURRENT--))\n"
         "  case $command in\n";
  for (const auto& command : commands) {
    out << "    " << command.name << ") _arguments";
    for (const auto& option : command.options)
      out << " "
          << quoted_word(option.name + "[" + escaped(option.help, "[]:\\") + "]" +
                         (option.takes_value ? ":value:_files" : ""));
    out << " '*:file:_files' ;;\n";
  }
  out << "  esac\n"
         "}\n"
         // Read by the completion system, the file is the function's body; sourced by hand, it has to be
         // named.
         "if [[ ${funcstack[1]:-} == _softwall ]]; then _softwall \"$@\"; else compdef _softwall softwall; "
         "fi\n";
  return out.str();
}

std::string for_fish(const std::vector<CommandWords>& commands) {
  std::ostringstream out;
  for (const auto& command : commands) {
    out << "complete -c softwall -n __fish_use_subcommand -f -a " << command.name << " -d "
        << quoted_word(command.help) << "\n";
    for (const auto& option : command.options)
      out << "complete -c softwall -n '__fish_seen_subcommand_from " << command.name << "' -l "
          << option.name.substr(2) << (option.takes_value ? " -r" : "") << " -d " << quoted_word(option.help)
          << "\n";
  }
  out << "complete -c softwall -n '__fish_seen_subcommand_from help' -f -a "
      << quoted_word(names_of(commands)) << "\n";
  return out.str();
}

}  // namespace

std::string completion_script(Shell shell, const std::vector<CommandWords>& commands) {
  switch (shell) {
    case Shell::kBash:
      return for_bash(commands);
    case Shell::kZsh:
      return for_zsh(commands);
    case Shell::kFish:
      return for_fish(commands);
  }
  return {};
}

}  // namespace softwall::campaign
