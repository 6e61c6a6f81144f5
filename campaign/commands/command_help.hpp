#pragma once

#include <memory>

namespace CLI {
class FormatterBase;
}

namespace softwall::campaign {

/// Writes the help of a command with examples of its use behind its first line.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_with_examples();

}  // namespace softwall::campaign
