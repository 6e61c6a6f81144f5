#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace softwall::campaign {

/// One row of the paper's tables 1 and 2. Units as in the results store.
struct PaperCase {
  std::string name;
  std::optional<double> viscosity_ratio;  ///< empty: the rigid reference
  std::optional<double> g_table, g_text;  ///< G under either reading [rho U_b^2]; empty: the rigid reference
  std::map<std::string, std::string>
      printed;  ///< by column of `results`: the digits as printed; empty: no value

  /// The digits of a column; empty where the paper prints none.
  [[nodiscard]] std::string digits(const std::string& column) const;
  [[nodiscard]] std::optional<double> number(const std::string& column) const;
};

/// The rows of analysis/data/rosti_brandt_2017_tables.csv, which is built into the program; read once.
[[nodiscard]] const std::vector<PaperCase>& paper_cases();

/// Reads the values from any text of that layout. Throws std::runtime_error naming the line that is wrong.
[[nodiscard]] std::vector<PaperCase> parse_paper_cases(std::string_view csv);

}  // namespace softwall::campaign
