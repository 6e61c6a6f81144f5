#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "solver/case/bad_input.hpp"
#include "solver/case/case.hpp"

namespace softwall {

/// Every mistake of a case document: of the schema, and of members that do not fit each other. filled: the
/// same document with all defaults.
[[nodiscard]] std::vector<Mistake> case_mistakes(const nlohmann::json& document,
                                                 const nlohmann::json& filled);

/// Checks, fills in defaults, converts. Throws BadInput, naming `source`, with every mistake.
[[nodiscard]] Case case_from_json(nlohmann::json document, const std::string& source);

/// The Case of a document that has no mistakes and all its defaults.
[[nodiscard]] Case valid_case(const nlohmann::json& filled);

}  // namespace softwall
