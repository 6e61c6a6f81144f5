#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/case/bad_input.hpp"

/// A sweep as a list of points. The object "sweep" of a campaign file has "grid", "zip", "list" and
/// "exclude".
namespace softwall::campaign {

/// Values by the pointer of their parameter inside "physics": {"/solid/G": 0.5}.
using Point = std::map<std::string, nlohmann::json>;

/// A sweep of more cases than this is a slip of the pen; it is refused before anything is allocated for it.
inline constexpr std::size_t kMostCases = 10000;

/// What the schema cannot say: names that are no parameter or one given twice, zipped lists of unequal
/// length, a sweep of more than kMostCases points (found without making them).
[[nodiscard]] std::vector<Mistake> sweep_mistakes(const nlohmann::json& sweep);

/// The points in the order written (in the grid the last parameter runs fastest); not yet without the
/// excluded ones. A sweep that names nothing is one point without values. Needs a sweep without mistakes.
[[nodiscard]] std::vector<Point> sweep_points(const nlohmann::json& sweep);

/// Sets the values of a point.
void put(const Point& point, nlohmann::json& physics);

/// Every parameter that some point sets.
[[nodiscard]] std::vector<std::string> swept_pointers(const std::vector<Point>& points);

}  // namespace softwall::campaign
