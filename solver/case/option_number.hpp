#pragma once

#include <string>

namespace softwall {

/// Numbers that an option of the command line may have.
struct OptionRange {
  double low = 0.0;
  bool low_allowed = true;  ///< false: greater than `low`
  double high = 0.0;
};

/// What is wrong with the text of an option, for users; empty when it is a number of the range. "nan" and
/// "inf" are numbers to most readers of text, and no limit anybody means.
[[nodiscard]] std::string trouble_with_number(const std::string& text, const OptionRange& range);

}  // namespace softwall
