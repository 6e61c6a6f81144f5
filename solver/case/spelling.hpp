#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace softwall {

/// Letters to insert, remove, replace or swap with their neighbour to turn one word into the other, without
/// regard to upper and lower case (optimal string alignment distance).
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The known word that was probably meant, if one is near: distance at most a third of the length, 2 for
/// short ones.
[[nodiscard]] std::optional<std::string> suggestion(std::string_view given,
                                                    const std::vector<std::string>& known);

}  // namespace softwall
