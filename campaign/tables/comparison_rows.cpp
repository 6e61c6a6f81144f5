#include "campaign/tables/comparison_rows.hpp"

#include <cstdlib>
#include <string>

#include "campaign/tables/comparison.hpp"

namespace softwall::campaign {
namespace {

Cell cell_of(const std::optional<double>& value) { return value ? Cell(*value) : Cell(std::monostate{}); }

/// The digits that the paper prints, as a number.
Cell printed_in(const PaperCase* paper, const char* column) {
  if (paper == nullptr) return std::monostate{};
  const auto printed = paper->printed.find(column);
  if (printed == paper->printed.end() || printed->second.empty()) return std::monostate{};
  return std::strtod(printed->second.c_str(), nullptr);
}

template <class Use>
void for_each_quantity(const Use& use) {
  for (const Quantity& quantity : kTable1) use(quantity);
  for (const Quantity& quantity : kTable2) use(quantity);
}

std::vector<Cell> row_of(const MeasuredCase& measured, const Reading* reading, const PaperCase* paper) {
  std::vector<Cell> row = {measured.label,
                           measured.case_id,
                           measured.state,
                           reading ? Cell(std::string(reading->name)) : Cell(std::monostate{}),
                           paper ? Cell(paper->name) : Cell(std::monostate{}),
                           cell_of(measured.g),
                           cell_of(measured.viscosity_ratio),
                           cell_of(measured.window_start),
                           cell_of(measured.window_end)};
  for_each_quantity([&](const Quantity& quantity) {
    const auto found = measured.values.find(quantity.column);
    const MeasuredValue value = found == measured.values.end() ? MeasuredValue{} : found->second;
    row.insert(row.end(), {cell_of(value.value), cell_of(value.ci95), printed_in(paper, quantity.column)});
  });
  return row;
}

}  // namespace

ResultTable comparison_rows(Connection& store) {
  ResultTable table{{"label", "case_id", "state", "reading", "paper_case", "G", "viscosity_ratio",
                     "window_start", "window_end"},
                    {}};
  for_each_quantity([&](const Quantity& quantity) {
    const std::string name = quantity.column;
    table.columns.insert(table.columns.end(), {name, name + "_ci95", name + "_paper"});
  });
  const auto papers = paper_cases();
  for (const MeasuredCase& measured : measured_cases(store)) {
    if (!has_counterpart(measured)) table.rows.push_back(row_of(measured, nullptr, nullptr));
    for (const Reading& reading : kReadings) {
      for (const PaperCase& paper : papers) {
        if (is_match(measured, paper, reading)) table.rows.push_back(row_of(measured, &reading, &paper));
      }
    }
  }
  return table;
}

}  // namespace softwall::campaign
