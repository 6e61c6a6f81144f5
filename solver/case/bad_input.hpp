#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace softwall {

/// One thing wrong in an input, said so that the reader can put it right.
struct Mistake {
  std::string where;    ///< JSON pointer ("/physics/grid/nx"), or "line 3, column 7"; may be empty
  std::string given;    ///< what stands there: "-3", "unknown key", "nothing"
  std::string allowed;  ///< what may stand there: "an integer from 4 to 100000"
};

/// All mistakes of an input at once. what() has the source's name and a line per mistake (the first 50).
struct BadInput : std::runtime_error {
  BadInput(const std::string& source_name, std::vector<Mistake> all);
  std::string source;  ///< file name or other description of the input
  std::vector<Mistake> mistakes;
};

/// Text that is safe to print: control characters and bytes that are not UTF-8 escaped, cut after `limit`
/// bytes.
[[nodiscard]] std::string printable_excerpt(std::string_view text, std::size_t limit = 80);

}  // namespace softwall
