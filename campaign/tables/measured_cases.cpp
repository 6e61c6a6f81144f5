#include "campaign/tables/measured_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace softwall::campaign {

namespace {

constexpr std::size_t kMostCharacters = 16;  // what keeps the widest table on its page

/// Asks the tables, because the view `results` would gather every column of every case first. All rows of a
/// result have the same window and note, and each result has the quantity "batches".
constexpr std::string_view kCases = R"sql(
SELECT c.case_id, c.flow, c.label, c.state, c.stale_reason, q.note, c.grid, c.G, c.viscosity_ratio, c.reynolds,
  iif(c.flow = 'rigid_channel', 0.0, json_extract(c.physics, '$.domain.layer_height')),
  q.window_start, q.window_end, c.end_time,
  json_extract(c.physics, '$.grid.nx'),
  json_extract(c.physics, '$.grid.ny_fluid') + json_extract(c.physics, '$.grid.ny_solid'),
  json_extract(c.physics, '$.grid.nz'),
  json_remove(c.physics, '$.grid', '$.statistics', '$.initial.precursor', '$.initial.precursor_time'),
  (SELECT group_concat(key || '=' || value, ' ') FROM json_each(c.varied)
    WHERE key NOT IN ('nx', 'ny_fluid', 'ny_solid', 'nz', 'stretching', 'interval_steps', 'block_length')
      AND key NOT LIKE 'grid.%' AND key NOT LIKE 'statistics.%')
FROM cases c LEFT JOIN quantities q ON q.case_id = c.case_id AND q.quantity = 'batches'
WHERE c.in_campaign = 1
ORDER BY c.G IS NOT NULL, c.viscosity_ratio = 1 DESC, c.viscosity_ratio, c.G DESC, c.case_id
LIMIT ?
)sql";

std::string fixed(double value, int decimals) {
  std::array<char, 64> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

std::string three_digits(double value) {
  std::array<char, 32> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.3g", value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

/// Decimals that show so many significant digits of a number; none of the digits before its point goes.
int decimals_for(double number, int digits) {
  return std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(number))));
}

std::string with_interval(double value, double ci95, int decimals) {
  return fixed(value, decimals) + " +- " + fixed(ci95, decimals);
}

/// "(923 +- 38)e-6"
std::string in_units_of_last_digit(double value, double ci95, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  return "(" + with_interval(value / unit, ci95 / unit, 0) + ")e-" + std::to_string(decimals);
}

/// As it would be written best, and what there is to fall back on where that is too long: two digits of the
/// half width, one of them rather than a number without its unit, and that where zeros fill the cell.
std::vector<std::string> ways_to_write(double value, double ci95) {
  constexpr int kDecimalsOfNothing = 4;
  if (!(ci95 > 0.0) || !std::isfinite(ci95)) return {with_interval(value, ci95, kDecimalsOfNothing)};
  const int two = decimals_for(ci95, 2), one = decimals_for(ci95, 1);
  return {with_interval(value, ci95, two), with_interval(value, ci95, one),
          in_units_of_last_digit(value, ci95, two)};
}

std::string value_and_interval(double value, double ci95) {
  for (const std::string& text : ways_to_write(value, ci95))
    if (text.size() <= kMostCharacters) return text;
  return three_digits(value) + " +- " + three_digits(ci95);
}

std::string without_interval(double value, int decimals) {
  const bool reads_as_zero = value != 0.0 && std::abs(value) < 0.5 * std::pow(10.0, -decimals);
  const std::string text = reads_as_zero ? three_digits(value) : fixed(value, decimals);
  return (text.size() <= kMostCharacters ? text : three_digits(value)) + " (*)";
}

void read_values(Connection& store, MeasuredCase& of) {
  Statement rows = store.query("SELECT quantity, value, ci95 FROM quantities WHERE case_id = ?", of.case_id);
  while (rows.step()) of.values[rows.text(0)] = {rows.optional_real(1), rows.optional_real(2)};
}

}  // namespace

MeasuredValue MeasuredCase::value(const std::string& column) const {
  const auto found = values.find(column);
  return found == values.end() ? MeasuredValue{} : found->second;
}

std::vector<MeasuredCase> measured_cases(Connection& store, std::int64_t most) {
  Statement rows = store.query(kCases, most);
  std::vector<MeasuredCase> cases;
  while (rows.step()) {
    MeasuredCase found;
    found.case_id = rows.text(0);
    found.flow = rows.text(1);
    found.label = rows.text(2);
    found.state = rows.text(3);
    found.stale_reason = rows.text(4);
    found.note = rows.text(5);
    found.grid = rows.text(6);
    found.g = rows.optional_real(7);
    found.viscosity_ratio = rows.optional_real(8);
    found.reynolds = rows.real(9);
    found.layer_height = rows.real(10);
    found.window_start = rows.optional_real(11);
    found.window_end = rows.optional_real(12);
    found.end_time = rows.real(13);
    found.sides = {rows.integer(14), rows.integer(15), rows.integer(16)};
    found.but_for_the_grid = rows.text(17);
    found.varied_but_for_the_grid = rows.text(18);
    cases.push_back(std::move(found));
  }
  for (MeasuredCase& one : cases) read_values(store, one);
  return cases;
}

std::string measured_text(const MeasuredValue& measured, int decimals) {
  if (!measured.value) return "-";
  return measured.ci95 ? value_and_interval(*measured.value, *measured.ci95)
                       : without_interval(*measured.value, decimals);
}

}  // namespace softwall::campaign
