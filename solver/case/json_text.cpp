#include "solver/case/json_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "solver/case/bad_input.hpp"

namespace softwall {
namespace {

using nlohmann::json;

std::string line_and_column(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, std::min(position, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 == 0 on the first line
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - line_start + 1);
}

/// nlohmann's message without its own prefix and position: "[json...] parse error at line 1, column 2: syntax
/// ...".
std::string reason(const std::string& message) {
  const std::size_t prefix = message.find("] ");
  std::string_view rest = message;
  if (prefix != std::string_view::npos) rest.remove_prefix(prefix + 2);
  if (rest.starts_with("parse error at ")) rest.remove_prefix(std::min(rest.size(), rest.find(": ") + 2));
  std::string text = printable_excerpt(rest, 200);
  for (std::size_t at = text.find("\\\""); at != std::string::npos; at = text.find("\\\"", at))
    text.erase(at, 1);
  return text;
}

/// Builds the document event by event, because only here can a key given twice be seen: nlohmann's own reader
/// silently keeps the last one.
class StrictReader : public nlohmann::json_sax<json> {
 public:
  StrictReader(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override {
    return add(normalised_number(static_cast<double>(value)));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add(normalised_number(static_cast<double>(value)));
  }
  bool number_float(number_float_t value, const string_t& /*text*/) override {
    return add(normalised_number(value));
  }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }  // not in text

  bool start_object(std::size_t /*size*/) override { return open(json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (open_.back().value.contains(name))
      repeated_.push_back({pointer() + "/" + name, "key given twice", "give it once"});
    open_.back().key = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::json::exception& error) override {
    // The position is that of the last byte read, counted from 1.
    refuse(line_and_column(text_, position == 0 ? 0 : position - 1), reason(error.what()));
  }

  /// The document, once the parser has gone through it. Throws BadInput if keys were repeated.
  [[nodiscard]] json take() {
    if (!repeated_.empty()) throw BadInput(source_, std::move(repeated_));
    return std::move(document_);
  }

 private:
  struct Open {
    json value;
    std::string key;  ///< in the enclosing value: under which this one's next member goes
  };

  bool add(json value) {
    if (++values_ > kJsonValueLimit)
      refuse("", "has more than " + std::to_string(kJsonValueLimit) + " values");
    if (open_.empty()) {
      document_ = std::move(value);
    } else if (open_.back().value.is_array()) {
      open_.back().value.push_back(std::move(value));
    } else {
      open_.back().value[open_.back().key] = std::move(value);
    }
    return true;
  }

  bool open(json empty) {
    if (open_.size() == kJsonDepthLimit)
      refuse("", "nested deeper than " + std::to_string(kJsonDepthLimit) + " levels");
    open_.push_back({std::move(empty), {}});
    return true;
  }

  bool close() {
    json value = std::move(open_.back().value);
    open_.pop_back();
    return add(std::move(value));
  }

  [[nodiscard]] std::string pointer() const {
    std::string path;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Open& level = open_[i];
      path +=
          "/" + (level.value.is_array() ? std::to_string(level.value.size()) : printable_excerpt(level.key));
    }
    return path;
  }

  [[noreturn]] void refuse(std::string where, std::string what) const {
    throw BadInput(source_, {{std::move(where), std::move(what), ""}});
  }

  std::string_view text_;
  const std::string& source_;
  json document_;
  std::vector<Open> open_;
  std::vector<Mistake> repeated_;
  std::size_t values_ = 0;
};

/// What nlohmann's reader lets pass: it skips a byte order mark and takes a NUL byte for the end of the text.
void refuse_odd_bytes(std::string_view text, const std::string& source) {
  const auto refuse = [&](std::size_t position, const char* what) {
    throw BadInput(source, {{line_and_column(text, position), what, "plain UTF-8 text is needed"}});
  };
  if (text.starts_with("\xEF\xBB\xBF")) refuse(0, "starts with a byte order mark");
  if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE")) refuse(0, "is UTF-16 text");
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
    refuse(nul, "contains a NUL byte");
}

}  // namespace

json parse_json(std::string_view text, const std::string& source) {
  refuse_odd_bytes(text, source);
  StrictReader reader(text, source);
  json::sax_parse(text, &reader);
  return reader.take();
}

json normalised_number(double value) {
  if (!std::isfinite(value))
    throw std::invalid_argument("a number that is not finite cannot be written as JSON");
  constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
  if (std::trunc(value) == value && std::abs(value) <= kExactIntegers)
    return static_cast<std::int64_t>(value);
  return value;
}

json normalised(json value) {
  if (value.is_number()) return normalised_number(value.get<double>());
  if (value.is_structured())
    for (auto& member : value) member = normalised(std::move(member));
  return value;
}

}  // namespace softwall
