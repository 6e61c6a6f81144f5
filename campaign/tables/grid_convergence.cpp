#include "campaign/tables/grid_convergence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "campaign/store/text_width.hpp"
#include "campaign/tables/comparison.hpp"
#include "campaign/tables/page.hpp"

namespace softwall::campaign {
namespace {

constexpr double kLeastRatio = 1.3;
constexpr std::array<Quantity, 2> kConverging = {kTable1[1], kTable2[3]};  // Re_tau and delta

bool has_result(const MeasuredCase& measured) {
  return measured.value(kConverging[0].column).value.has_value();
}

std::int64_t cells_of(const MeasuredCase& measured) {
  return measured.sides[0] * measured.sides[1] * measured.sides[2];
}

/// Empty where the directions are not refined alike, so that the grids have no one ratio.
std::optional<double> ratio_of_spacings(const MeasuredCase& coarser, const MeasuredCase& finer) {
  constexpr double kAlike = 0.1;
  const double ratio =
      std::cbrt(static_cast<double>(cells_of(finer)) / static_cast<double>(cells_of(coarser)));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = static_cast<double>(finer.sides[axis]) / static_cast<double>(coarser.sides[axis]);
    if (std::abs(along - ratio) > kAlike * ratio) return std::nullopt;
  }
  return ratio;
}

/// By grid, the coarsest first. Cases of one physics differ in nothing but their grid.
std::vector<CaseOnGrids> by_physics(const std::vector<MeasuredCase>& cases) {
  std::vector<CaseOnGrids> groups;
  for (const MeasuredCase& one : cases) {
    const auto group = std::ranges::find_if(
        groups, [&](const CaseOnGrids& other) { return other[0]->but_for_the_grid == one.but_for_the_grid; });
    if (group == groups.end())
      groups.push_back({&one});
    else
      group->push_back(&one);
  }
  for (CaseOnGrids& group : groups)
    std::ranges::stable_sort(group, {}, [](const MeasuredCase* one) { return cells_of(*one); });
  return groups;
}

/// "+2.4 +- 1.4", in percent.
std::string percent(const MeasuredValue& part) {
  MeasuredValue percent = part;
  if (percent.value) *percent.value *= 100;
  if (percent.ci95) *percent.ci95 *= 100;
  return (percent.value && *percent.value >= 0 ? "+" : "") + measured_text(percent, 1);
}

/// In the first column its name stands only beside the coarsest grid.
std::string name_of(const MeasuredCase& measured) {
  if (!measured.varied_but_for_the_grid.empty()) return measured.varied_but_for_the_grid;
  return measured.g ? "elastic wall" : "rigid walls";
}

Row row_of_grid(const MeasuredCase& here, const MeasuredCase* coarser) {
  Row row = {coarser ? "" : shortened(printable(name_of(here)), kFirstColumnWidth), here.grid};
  for (const Quantity& quantity : kConverging) {
    row.push_back(measured_text(here.value(quantity.column), quantity.decimals));
    row.push_back(coarser ? percent(change(*coarser, here, quantity.column)) : "");
  }
  return row;
}

Row extrapolated_row(const MeasuredCase& coarser, const MeasuredCase& finer) {
  Row row = {"", "extrapolated"};
  for (const Quantity& quantity : kConverging) {
    row.push_back(measured_text(extrapolated(coarser, finer, quantity.column), quantity.decimals));
    row.emplace_back();
  }
  return row;
}

}  // namespace

std::vector<CaseOnGrids> cases_on_grids(const std::vector<MeasuredCase>& cases) {
  std::vector<CaseOnGrids> groups = by_physics(cases);
  for (CaseOnGrids& group : groups)
    std::erase_if(group, [](const MeasuredCase* one) { return !has_result(*one); });
  std::erase_if(groups, [](const CaseOnGrids& group) { return group.size() < 2; });
  return groups;
}

std::vector<MeasuredCase> finest_of_each(const std::vector<MeasuredCase>& cases) {
  std::vector<MeasuredCase> finest;
  for (const CaseOnGrids& group : by_physics(cases)) {
    const auto best = std::ranges::max_element(
        group, {}, [](const MeasuredCase* one) { return std::pair(has_result(*one), cells_of(*one)); });
    finest.push_back(**best);
  }
  return finest;
}

MeasuredValue change(const MeasuredCase& coarser, const MeasuredCase& finer, const std::string& column) {
  const MeasuredValue before = coarser.value(column), now = finer.value(column);
  if (!before.value || !now.value || *now.value == 0) return {};
  const double ratio = *before.value / *now.value;
  MeasuredValue part{1 - ratio, std::nullopt};
  if (before.ci95 && now.ci95) part.ci95 = std::hypot(*before.ci95, ratio * *now.ci95) / std::abs(*now.value);
  return part;
}

MeasuredValue extrapolated(const MeasuredCase& coarser, const MeasuredCase& finer,
                           const std::string& column) {
  const MeasuredValue before = coarser.value(column), now = finer.value(column);
  const auto found = ratio_of_spacings(coarser, finer);
  if (!before.value || !now.value || !found || *found < kLeastRatio) return {};
  const double ratio = *found;
  const double gap = *now.value - *before.value;
  const double second_order = 1 / (ratio * ratio - 1), first_order = 1 / (ratio - 1);
  MeasuredValue limit{*now.value + second_order * gap, std::nullopt};
  if (before.ci95 && now.ci95) {
    limit.ci95 = std::hypot((1 + second_order) * *now.ci95, second_order * *before.ci95,
                            (first_order - second_order) * gap);
  }
  return limit;
}

void write_grid_convergence(std::ostream& out, const std::vector<MeasuredCase>& cases) {
  const std::vector<CaseOnGrids> groups = cases_on_grids(cases);
  if (groups.empty()) return;
  out << "\nWHAT THE GRID CHANGES\n"
      << wrapped(
             "change: from the grid above, in percent of the finer value; extrapolated: to vanishing spacing "
             "from the two "
             "finest grids, with errors of second order; its half width joins their intervals and the "
             "distance to what "
             "errors of first order would give",
             kPageWidth)
      << "\n";
  std::vector<Row> rows = {
      {"case", "grid", kConverging[0].heading, "change [%]", kConverging[1].heading, "change [%]"}};
  for (const CaseOnGrids& group : groups) {
    for (std::size_t i = 0; i < group.size(); ++i)
      rows.push_back(row_of_grid(*group[i], i > 0 ? group[i - 1] : nullptr));
    rows.push_back(extrapolated_row(*group[group.size() - 2], *group.back()));
  }
  constexpr Column kNumber{Alignment::kRight};
  write_aligned(out, rows, {{Alignment::kLeft, kFirstColumnWidth}, {}, kNumber, kNumber, kNumber, kNumber});
}

}  // namespace softwall::campaign
