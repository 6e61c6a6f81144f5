#include "campaign/tables/comparison_rows.hpp"

#include <string>

#include "campaign/tables/comparison.hpp"

namespace softwall::campaign {
namespace {

Cell cell_of(const std::optional<double>& value) { return value ? Cell(*value) : Cell(std::monostate{}); }

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
    const MeasuredValue value = measured.value(quantity.column);
    const auto printed = paper ? paper->number(quantity.column) : std::nullopt;
    row.insert(row.end(), {cell_of(value.value), cell_of(value.ci95), cell_of(printed)});
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
  for (const MeasuredCase& measured : measured_cases(store)) {
    if (!has_counterpart(measured)) table.rows.push_back(row_of(measured, nullptr, nullptr));
    for (const Reading& reading : kReadings) {
      for (const PaperCase& paper : paper_cases()) {
        if (is_match(measured, paper, reading)) table.rows.push_back(row_of(measured, &reading, &paper));
      }
    }
  }
  return table;
}

}  // namespace softwall::campaign
