#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace softwall::campaign {

/// What is wrong with an expression, or with what it gives, in words for the one who wrote it.
struct ExpressionError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Arithmetic on named numbers, as in "2800 * G" or "max(4, round(ny_fluid / 4))": + - * / with the usual
/// precedence, parentheses, signs, numbers, names, and the functions min, max and round.
class Expression {
 public:
  /// Throws ExpressionError that names the character where it cannot be read any further.
  explicit Expression(std::string_view text);

  /// The names in it, each once, in the order written.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// Throws ExpressionError where it divides by zero or leaves the finite numbers.
  [[nodiscard]] double value(const std::function<double(const std::string&)>& value_of) const;

 private:
  friend class ExpressionParser;
  enum class Operation { kNumber, kName, kNegate, kRound, kAdd, kSubtract, kMultiply, kDivide, kMin, kMax };
  /// One step of a stack machine: it puts a number there, or replaces the topmost by what it makes of them.
  struct Step {
    Operation operation;
    double number = 0;     ///< of kNumber
    std::size_t name = 0;  ///< of kName: its place in names_
  };
  [[nodiscard]] static double combined(Operation operation, double a, double b);

  std::vector<Step> steps_;
  std::vector<std::string> names_;
};

}  // namespace softwall::campaign
