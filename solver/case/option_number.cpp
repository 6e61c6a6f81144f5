#include "solver/case/option_number.hpp"

#include <charconv>

#include "solver/case/bad_input.hpp"
#include "solver/case/json_text.hpp"

namespace softwall {
namespace {

std::string text_of(double value) { return normalised_number(value).dump(); }

}  // namespace

std::string trouble_with_number(const std::string& text, const OptionRange& range) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const bool is_number = error == std::errc{} && rest == end;
  const bool above = range.low_allowed ? value >= range.low : value > range.low;
  if (is_number && above && value <= range.high) return "";
  return printable_excerpt(text) + " is not a number " +
         (range.low_allowed ? "of at least " : "greater than ") + text_of(range.low) + " and of at most " +
         text_of(range.high);
}

}  // namespace softwall
