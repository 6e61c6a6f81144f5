#pragma once

#include "solver/case/json_schema.hpp"

namespace softwall {

/// schemas/case.schema.json as built into the program.
[[nodiscard]] const JsonSchema& case_schema();

}  // namespace softwall
