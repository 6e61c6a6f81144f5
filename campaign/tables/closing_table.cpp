#include "campaign/tables/closing_table.hpp"

#include <array>
#include <cstdio>
#include <ostream>
#include <string>

#include "campaign/store/text_width.hpp"
#include "campaign/tables/measured_cases.hpp"

namespace softwall::campaign {
namespace {

struct Shown {
  const char* column;
  const char* heading;
  int decimals;  ///< of a value without interval
};
constexpr std::array<Shown, 7> kShown = {{{"re_tau_w", "Re_tau^w", 1},
                                          {"re_tau", "Re_tau", 1},
                                          {"u_max", "u_max [U_b]", 3},
                                          {"y_max", "y_max [h]", 3},
                                          {"delta_u_plus", "DU+", 1},
                                          {"delta_max", "delta [h]", 4},
                                          {"delta_rms", "delta' [h]", 4}}};

constexpr std::int64_t kMostCases = 100;  // more lines than that nobody reads at the end of a run

std::string window_of(const MeasuredCase& measured) {
  if (!measured.window_start || !measured.window_end) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%g-%g", *measured.window_start, *measured.window_end);
  return text.data();
}

}  // namespace

void write_closing_table(std::ostream& out, Connection& store) {
  std::vector<std::vector<std::string>> rows = {{"case", "state", "t [h/U_b]"}};
  std::vector<Column> columns(3);
  for (const Shown& shown : kShown) {
    rows[0].emplace_back(shown.heading);
    columns.push_back({Alignment::kRight});
  }
  for (const MeasuredCase& measured : measured_cases(store, kMostCases)) {
    std::vector<std::string> row = {printable(measured.label), measured.state, window_of(measured)};
    for (const Shown& shown : kShown) {
      row.push_back(measured_text(measured.value(shown.column), shown.decimals));
    }
    rows.push_back(std::move(row));
  }
  write_aligned(out, rows, columns);
  const auto cases = store.integer("SELECT count(*) FROM cases WHERE in_campaign = 1");
  if (cases > kMostCases)
    out << "and " << cases - kMostCases << " cases more: softwall table and softwall export have them all\n";
  out << "value +- half width of its 95 % interval; (*): none can be given, softwall table says why\n";
}

}  // namespace softwall::campaign
