#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

/// Text in columns on a terminal.
namespace softwall::campaign {

/// Makes a text harmless on a terminal: control characters, invalid UTF-8 and the characters that turn the
/// direction of writing around become \n, \x1b, ...
[[nodiscard]] std::string printable(std::string_view text);

/// Makes a message of several lines harmless, and keeps its line breaks.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// Characters (code points) of a UTF-8 text.
[[nodiscard]] std::size_t width_of(std::string_view text);

/// At most `width` characters, the last three of them "..." when some had to go. width >= 3.
[[nodiscard]] std::string shortened(const std::string& text, std::size_t width);

enum class Alignment { kLeft, kRight };

struct Column {
  Alignment alignment = Alignment::kLeft;
  std::size_t minimum = 0;  ///< characters
};

/// One line a row, columns two blanks apart and as wide as their widest cell; no blanks at the end of a line.
void write_aligned(std::ostream& out, const std::vector<std::vector<std::string>>& rows,
                   const std::vector<Column>& columns);

/// Breaks at blanks into lines of at most `width` characters; every line but the first begins with `indent`.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::string_view indent = "");

}  // namespace softwall::campaign
