#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "solver/case/bad_input.hpp"

namespace softwall {

/// What a schema cannot say: members that must fit each other. `filled` has its defaults; `known` are the
/// mistakes already found by the schema, and nothing is derived from members named there.
[[nodiscard]] std::vector<Mistake> case_cross_checks(const nlohmann::json& filled,
                                                     const std::vector<Mistake>& known);

}  // namespace softwall
