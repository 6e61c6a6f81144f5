#pragma once

#include <array>
#include <optional>
#include <vector>

#include "campaign/tables/measured_cases.hpp"
#include "campaign/tables/paper_values.hpp"

/// Which of our cases stand beside which of the paper's, and what of them is shown.
namespace softwall::campaign {

struct Quantity {
  const char* column;   ///< of `results`
  const char* heading;  ///< in plain text
  const char* latex;    ///< in mathematics
  int decimals;         ///< of a measured value without interval: one more than the paper prints
};
inline constexpr std::array<Quantity, 4> kTable1 = {{{"re_tau_w", "Re_tau^w", "Re_\\tau^w", 1},
                                                     {"re_tau", "Re_tau", "Re_\\tau", 1},
                                                     {"u_max", "u_M/U_b", "u_M/U_b", 3},
                                                     {"y_max", "y_M/h", "y_M/h", 3}}};
inline constexpr std::array<Quantity, 5> kTable2 = {{{"d", "d/h", "d/h", 3},
                                                     {"k_plus_dk", "k+Dk", "k+\\Delta k", 3},
                                                     {"delta_u_plus", "DU+", "\\Delta U^+", 1},
                                                     {"delta_max", "delta/h", "\\delta/h", 4},
                                                     {"delta_rms", "delta'/h", "\\delta'/h", 4}}};

/// The paper contradicts itself on G: its text has half of what its tables print. The third reading is half
/// of the text's, as if the factor had been applied twice.
struct Reading {
  const char* name;
  const char* title;
  double of_table;  ///< G over what the tables print

  /// Of a case; empty for the rigid reference.
  [[nodiscard]] std::optional<double> modulus(const PaperCase& paper) const {
    return paper.g_table ? std::optional(of_table * *paper.g_table) : std::nullopt;
  }
};
inline constexpr std::array<Reading, 3> kReadings = {
    {{"table", "READING \"TABLE\": G as the paper's tables print it, 4.0, 2.0, 1.0, 0.5", 1},
     {"text", "READING \"TEXT\": G as the paper's text says, 2.0, 1.0, 0.5, 0.25 (half of the tables')", 0.5},
     {"half", "READING \"HALF\": half of the text's G, 1.0, 0.5, 0.25, 0.125", 0.25}}};

/// The paper has channels of one Reynolds number and one layer; other cases have no counterpart in it.
[[nodiscard]] bool is_match(const MeasuredCase& measured, const PaperCase& paper, const Reading& reading);
[[nodiscard]] bool has_counterpart(const MeasuredCase& measured);

}  // namespace softwall::campaign
