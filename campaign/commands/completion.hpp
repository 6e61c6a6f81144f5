#pragma once

#include <string>
#include <vector>

/// Scripts by which a shell completes what is typed behind "softwall".
namespace softwall::campaign {

struct OptionWords {
  std::string name;  ///< "--watch"
  std::string help;
  bool takes_value = false;
};

struct CommandWords {
  std::string name, help;
  std::vector<OptionWords> options;
};

enum class Shell { kBash, kZsh, kFish };

/// The script for one shell. Names of commands and options are plain words; helps may hold any character.
[[nodiscard]] std::string completion_script(Shell shell, const std::vector<CommandWords>& commands);

}  // namespace softwall::campaign
