#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "campaign/tables/measured_cases.hpp"

/// What the grid does to a result. Grids are compared by their representative spacing, the cube root of the
/// volume of a cell (Celik et al., J. Fluids Eng. 130, 2008), whatever their stretching.
namespace softwall::campaign {

/// One physical case on grids with a result, the coarsest first.
using CaseOnGrids = std::vector<const MeasuredCase*>;

/// Those of which results exist on more than one grid, in the order of `cases`, whose lifetime they share.
[[nodiscard]] std::vector<CaseOnGrids> cases_on_grids(const std::vector<MeasuredCase>& cases);

/// Of each physical case the finest grid that has a result, or one without if none has.
[[nodiscard]] std::vector<MeasuredCase> finest_of_each(const std::vector<MeasuredCase>& cases);

/// (finer - coarser) / finer, with the half width that follows from those of both, which are independent;
/// without half width where an interval is missing, empty where a value is.
[[nodiscard]] MeasuredValue change(const MeasuredCase& coarser, const MeasuredCase& finer,
                                   const std::string& column);

/// The value at vanishing spacing if the error fell with its square. The half width joins, as root of the sum
/// of squares, what the two intervals amount to and the distance to the value if the error fell with the
/// spacing itself: with two grids the order is not known, and with three the intervals would hide it. Without
/// half width where an interval is missing; empty where a value is, where the directions are not refined
/// alike, or where the spacings are not in a ratio of 1.3 at least, as Celik et al. ask.
[[nodiscard]] MeasuredValue extrapolated(const MeasuredCase& coarser, const MeasuredCase& finer,
                                         const std::string& column);

/// A line for each grid and one for what the two finest extrapolate to; nothing if no case has two grids.
void write_grid_convergence(std::ostream& out, const std::vector<MeasuredCase>& cases);

}  // namespace softwall::campaign
