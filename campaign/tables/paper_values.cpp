#include "campaign/tables/paper_values.hpp"

#include <charconv>
#include <sstream>
#include <stdexcept>

#include "campaign/tables/embedded_paper.hpp"

namespace softwall::campaign {

namespace {

/// No field of this file is quoted.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

std::optional<double> number_in(const std::string& text, const std::string& line) {
  if (text.empty()) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::runtime_error("the paper's tables: '" + text + "' is no number in: " + line);
  }
  return value;
}

PaperCase case_in(const std::string& line, const std::vector<std::string>& columns) {
  const std::vector<std::string> fields = fields_of(line);
  if (fields.size() != columns.size()) {
    throw std::runtime_error("the paper's tables: " + std::to_string(fields.size()) + " fields instead of " +
                             std::to_string(columns.size()) + " in: " + line);
  }
  PaperCase result;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::optional<double> number = columns[i] == "case" ? std::nullopt : number_in(fields[i], line);
    if (columns[i] == "case") {
      result.name = fields[i];
    } else if (columns[i] == "viscosity_ratio") {
      result.viscosity_ratio = number;
    } else if (columns[i] == "G_table") {
      result.g_table = number;
    } else if (columns[i] == "G_text") {
      result.g_text = number;
    } else {
      result.printed[columns[i]] = fields[i];
    }
  }
  return result;
}

}  // namespace

std::string PaperCase::digits(const std::string& column) const {
  const auto found = printed.find(column);
  return found == printed.end() ? "" : found->second;
}

std::optional<double> PaperCase::number(const std::string& column) const {
  return number_in(digits(column), name);
}

std::vector<PaperCase> parse_paper_cases(std::string_view csv) {
  std::istringstream lines{std::string(csv)};
  std::vector<std::string> columns;
  std::vector<PaperCase> cases;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (columns.empty()) {
      columns = fields_of(line);
    } else {
      cases.push_back(case_in(line, columns));
    }
  }
  return cases;
}

const std::vector<PaperCase>& paper_cases() {
  static const std::vector<PaperCase> cases = parse_paper_cases(schemas::kRostiBrandt2017TablesCsv);
  return cases;
}

}  // namespace softwall::campaign
