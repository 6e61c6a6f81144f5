#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

/// A table of values, and the ways to write it.
namespace softwall::campaign {

/// monostate: NULL.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// A number without a fraction, such as steps or cells, as a cell: an integer where one can hold it.
[[nodiscard]] Cell whole_number(double value);

struct ResultTable {
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as columns
};

enum class TableFormat { kText, kVertical, kCsv, kJson };

/// Text: for users, aligned, numbers to six significant digits, control characters made visible. Vertical:
/// the same, one value a line beside the name of its column, an empty line between rows. CSV: RFC 4180 with
/// LF, header first, NULL empty and the empty text "", all digits; a row that is a single NULL is "", because
/// readers drop blank lines. JSON: array of objects, numbers as numbers with all digits, NULL and non-finite
/// numbers as null.
void write_table(std::ostream& out, const ResultTable& table, TableFormat format);

}  // namespace softwall::campaign
