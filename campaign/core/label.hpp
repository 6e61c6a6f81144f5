#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace softwall::campaign {

/// "G=0.5_mu=10" from {{"G", 0.5}, {"viscosity_ratio", 10}}; safe as a file name.
[[nodiscard]] std::string label_of(const std::vector<std::pair<std::string, nlohmann::json>>& parameters);

/// Letters, digits and . _ = - only, others become "-"; never empty, never starting with "." or "-", at most
/// 80 long.
[[nodiscard]] std::string safe_label(const std::string& text);

/// "cases/<label>-<first 8 of the id>". The id keeps apart what labels do not.
[[nodiscard]] std::string case_directory(const std::string& label, const std::string& case_id);

}  // namespace softwall::campaign
