#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace softwall::campaign {

/// What schemas/results.sql says about a column, or with an empty column about a table or view.
struct ColumnDocumentation {
  std::string object, column, unit, meaning;
};

/// Reads the comments of a schema laid out one column a line, "name ..., -- [unit] meaning". A comment line
/// above CREATE documents the table or view; a comment line inside continues the meaning of the column above
/// it.
[[nodiscard]] std::vector<ColumnDocumentation> documentation_in(std::string_view sql);

}  // namespace softwall::campaign
