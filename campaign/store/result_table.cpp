#include "campaign/store/result_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>

#include "campaign/store/text_width.hpp"

namespace softwall::campaign {

namespace {

/// Shortest text that reads back as the same number.
std::string all_digits(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

std::string six_digits(double value) {
  std::array<char, 32> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

struct TextCell {
  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return six_digits(value); }
  std::string operator()(const std::string& value) const { return printable(value); }
};

std::string quoted(const std::string& value) {
  std::string result = "\"";
  for (const char c : value) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

struct CsvCell {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return all_digits(value); }
  std::string operator()(const std::string& value) const {
    const bool plain = !value.empty() && value.find_first_of(",\"\r\n") == std::string::npos &&
                       value.front() != ' ' && value.back() != ' ';
    return plain ? value : quoted(value);
  }
};

std::string json_text(const std::string& value) {
  return nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

struct JsonCell {
  std::string operator()(std::monostate) const { return "null"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return std::isfinite(value) ? all_digits(value) : "null"; }
  std::string operator()(const std::string& value) const { return json_text(value); }
};

bool is_text(const Cell& cell) { return std::holds_alternative<std::string>(cell); }

void write_text(std::ostream& out, const ResultTable& table) {
  std::vector<std::vector<std::string>> lines(1);
  for (const std::string& name : table.columns) lines[0].push_back(printable(name));
  for (const auto& row : table.rows) {
    lines.emplace_back();
    for (const Cell& cell : row) lines.back().push_back(std::visit(TextCell{}, cell));
  }
  std::vector<Column> columns(table.columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool text =
        std::any_of(table.rows.begin(), table.rows.end(), [i](const auto& row) { return is_text(row[i]); });
    columns[i].alignment = text ? Alignment::kLeft : Alignment::kRight;
  }
  write_aligned(out, lines, columns);
}

void write_vertical(std::ostream& out, const ResultTable& table) {
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (row > 0) out << '\n';
    std::vector<std::vector<std::string>> lines;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      lines.push_back({printable(table.columns[i]), std::visit(TextCell{}, table.rows[row][i])});
    write_aligned(out, lines, {{Alignment::kLeft}, {Alignment::kLeft}});
  }
}

void write_csv(std::ostream& out, const ResultTable& table) {
  const auto write_line = [&out](const auto& cells, const auto& text_of) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "," : "") + text_of(cells[i]);
    out << (line.empty() ? "\"\"" : line) << '\n';  // readers drop blank lines
  };
  write_line(table.columns, CsvCell{});
  for (const auto& row : table.rows) {
    write_line(row, [](const Cell& cell) { return std::visit(CsvCell{}, cell); });
  }
}

/// JSON readers keep one of two members of the same name: the second becomes name_2.
std::vector<std::string> distinct(const std::vector<std::string>& names) {
  std::map<std::string, int> seen;
  std::vector<std::string> result;
  for (const std::string& name : names) {
    const int count = ++seen[name];
    result.push_back(count == 1 ? name : name + "_" + std::to_string(count));
  }
  return result;
}

void write_json(std::ostream& out, const ResultTable& table) {
  const std::vector<std::string> names = distinct(table.columns);
  out << '[';
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    out << (row > 0 ? ",\n {" : "\n {");
    for (std::size_t i = 0; i < names.size(); ++i) {
      out << (i > 0 ? ", " : "") << json_text(names[i]) << ": " << std::visit(JsonCell{}, table.rows[row][i]);
    }
    out << '}';
  }
  out << (table.rows.empty() ? "]\n" : "\n]\n");
}

}  // namespace

Cell whole_number(double value) {
  constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
  if (std::abs(value) <= kExactIntegers) return static_cast<std::int64_t>(value);
  return value;
}

void write_table(std::ostream& out, const ResultTable& table, TableFormat format) {
  switch (format) {
    case TableFormat::kText:
      return write_text(out, table);
    case TableFormat::kVertical:
      return write_vertical(out, table);
    case TableFormat::kCsv:
      return write_csv(out, table);
    case TableFormat::kJson:
      return write_json(out, table);
  }
}

}  // namespace softwall::campaign
