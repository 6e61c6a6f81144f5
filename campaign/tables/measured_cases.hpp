#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {

struct MeasuredValue {
  std::optional<double> value, ci95;
};

/// A case of the present sweep as the table of results shows it.
struct MeasuredCase {
  std::string case_id, label, flow, state, stale_reason, note, grid;
  std::string varied_but_for_the_grid;  ///< "G=0.5 viscosity_ratio=1": what the sweep gave it but the grid
  /// All physical parameters but the grid's and those of the precursor, which has the same grid; JSON.
  std::string but_for_the_grid;
  std::array<std::int64_t, 3> sides{};       ///< cells along x, y, z
  std::optional<double> g, viscosity_ratio;  ///< empty: rigid walls
  double reynolds = 0.0;
  double layer_height = 0.0;                       ///< [h]; 0: rigid walls
  std::optional<double> window_start, window_end;  ///< [h/U_b]; empty: nothing measured yet
  double end_time = 0.0;                           ///< [h/U_b]
  std::map<std::string, MeasuredValue> values;     ///< by column of `results`

  /// Without a value where nothing was measured.
  [[nodiscard]] MeasuredValue value(const std::string& column) const;
};

/// In the order of the paper's tables, the first `most` of them; cases left over from an earlier sweep are
/// left out.
[[nodiscard]] std::vector<MeasuredCase> measured_cases(
    Connection& store, std::int64_t most = std::numeric_limits<std::int64_t>::max());

/// "240.5 +- 3.2": as many decimals as two digits of the half width call for, or one of them where that makes
/// 16 characters of it; "(923 +- 38)e-6" where zeros would. "240.52 (*)": without interval, with so many
/// decimals. "-": no value. What is not zero does not read as zero.
[[nodiscard]] std::string measured_text(const MeasuredValue& measured, int decimals);

}  // namespace softwall::campaign
