#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace softwall {

/// Identity of a case: 16 hexadecimal digits from the object "physics" of a valid case.json.
/// Two spellings of the same physics give the same id: order of keys, 1 or 1.0 or 1e0, -0 or 0, defaults
/// written or left out. What a rigid channel does not have (layer_height, solid) does not enter for one, nor
/// what carries phi (solid.interface) where a reference map does.
/// Members equal to their default are dropped before hashing, so that a parameter added to the schema later,
/// with a default that means "as before", leaves the id of every finished case as it was. Hence a default
/// that changes leaves its first value behind in the schema, as "identity_default", and that one is dropped:
/// no old id ever means new physics. Throws std::invalid_argument for a number that is not finite.
[[nodiscard]] std::string case_id(const nlohmann::json& physics);

/// The text that is hashed: no white space, keys sorted, numbers in their shortest form that reads back
/// exactly.
[[nodiscard]] std::string canonical_text(const nlohmann::json& value);

}  // namespace softwall
