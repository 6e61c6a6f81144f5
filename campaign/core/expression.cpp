#include "campaign/core/expression.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "solver/case/bad_input.hpp"
#include "solver/case/spelling.hpp"

namespace softwall::campaign {

/// By recursive descent, one function a line of the grammar:
///   sum     = product { ("+" | "-") product }
///   product = signed { ("*" | "/") signed }
///   signed  = { "+" | "-" } operand
///   operand = number | name | function "(" sum { "," sum } ")" | "(" sum ")"
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, Expression& into) : text_(text), into_(into) {}

  void parse() {
    sum();
    if (!at_end()) fail("expected + - * / or the end");
  }

 private:
  using Operation = Expression::Operation;

  void sum() {
    product();
    while (true) {
      if (take('+')) {
        product();
        step(Operation::kAdd);
      } else if (take('-')) {
        product();
        step(Operation::kSubtract);
      } else {
        return;
      }
    }
  }

  void product() {
    with_sign();
    while (true) {
      if (take('*')) {
        with_sign();
        step(Operation::kMultiply);
      } else if (take('/')) {
        with_sign();
        step(Operation::kDivide);
      } else {
        return;
      }
    }
  }

  void with_sign() {
    bool negative = false;
    while (true) {
      if (take('-'))
        negative = !negative;
      else if (!take('+'))
        break;
    }
    operand();
    if (negative) step(Operation::kNegate);
  }

  void operand() {
    if (at_end()) fail("expected a number, a parameter or \"(\"");
    const char first = text_[at_];
    if (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '.') return number();
    if (starts_name(first)) return named();
    if (!take('(')) fail("expected a number, a parameter or \"(\"");
    enter();
    sum();
    close();
  }

  void number() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("expected a number that can be held");
    at_ = static_cast<std::size_t>(end - text_.data());
    into_.steps_.push_back({.operation = Operation::kNumber, .number = value});
  }

  void named() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (starts_name(text_[at_]) || continues_name(text_[at_]))) ++at_;
    std::string name(text_.substr(begin, at_ - begin));
    if (take('(')) return call(name, begin);
    const auto known = std::ranges::find(into_.names_, name);
    const auto place = static_cast<std::size_t>(known - into_.names_.begin());
    if (known == into_.names_.end()) into_.names_.push_back(std::move(name));
    into_.steps_.push_back({.operation = Operation::kName, .name = place});
  }

  void call(const std::string& function, std::size_t begin) {
    if (function != "min" && function != "max" && function != "round") {
      at_ = begin;
      const auto meant = suggestion(function, {"min", "max", "round"});
      fail("no such function: " + function + (meant ? "; did you mean " + *meant + "?" : ""));
    }
    enter();
    sum();
    if (function == "round") {
      step(Operation::kRound);
    } else {
      while (take(',')) {
        sum();
        step(function == "min" ? Operation::kMin : Operation::kMax);
      }
    }
    close();
  }

  /// Nobody writes so many parentheses, and the stack has an end.
  void enter() {
    constexpr int kDeepest = 64;
    if (++depth_ > kDeepest) fail("parentheses too deep");
  }

  void close() {
    if (!take(')')) fail("expected \")\"");
    --depth_;
  }

  static bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
  static bool continues_name(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.'; }

  bool at_end() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ == text_.size();
  }

  bool take(char wanted) {
    if (at_end() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  void step(Operation operation) { into_.steps_.push_back({.operation = operation}); }

  [[noreturn]] void fail(const std::string& what) {
    throw ExpressionError(at_end() ? what + " after the last character"
                                   : what + " at character " + std::to_string(at_ + 1) + ", \"" +
                                         printable_excerpt(text_.substr(at_), 20) + "\"");
  }

  std::string_view text_;
  Expression& into_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

Expression::Expression(std::string_view text) { ExpressionParser(text, *this).parse(); }

double Expression::combined(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::kAdd:
      return a + b;
    case Operation::kSubtract:
      return a - b;
    case Operation::kMultiply:
      return a * b;
    case Operation::kMin:
      return std::min(a, b);
    case Operation::kMax:
      return std::max(a, b);
    default:
      if (b == 0) throw ExpressionError("divides by zero");
      return a / b;
  }
}

double Expression::value(const std::function<double(const std::string&)>& value_of) const {
  std::vector<double> stack;
  for (const Step& step : steps_) {
    switch (step.operation) {
      case Operation::kNumber:
        stack.push_back(step.number);
        break;
      case Operation::kName:
        stack.push_back(value_of(names_[step.name]));
        break;
      case Operation::kNegate:
        stack.back() = -stack.back();
        break;
      case Operation::kRound:
        stack.back() = std::round(stack.back());
        break;
      default:
        const double b = stack.back();
        stack.pop_back();
        stack.back() = combined(step.operation, stack.back(), b);
    }
    if (!std::isfinite(stack.back())) throw ExpressionError("is not a finite number");
  }
  return stack.back();
}

}  // namespace softwall::campaign
