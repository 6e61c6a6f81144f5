#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "solver/case/bad_input.hpp"

/// The object "start_from" of a campaign file: cases that differ in one parameter alone stand in a line, by
/// its values, and each starts from the end of the one before it; the first starts as it would otherwise.
/// Which that is follows from the campaign file, never from what has finished.
namespace softwall::campaign {

struct StartFrom {
  std::string nearest;       ///< parameter inside "physics": "/solid/G"
  bool from_largest = true;  ///< the case with the largest value is the first of its line
  [[nodiscard]] bool operator==(const StartFrom&) const = default;
};

/// What the schema cannot say. start_from: as filled in by the schema; null: none. flow: its name in a
/// campaign file.
[[nodiscard]] std::vector<Mistake> start_from_mistakes(const nlohmann::json& start_from,
                                                       const nlohmann::json& until, const std::string& flow);

/// Needs a "start_from" without mistakes.
[[nodiscard]] std::optional<StartFrom> start_from_of(const nlohmann::json& start_from);

/// "largest G"
[[nodiscard]] std::string words_of(const StartFrom& start_from);

/// Where a case stands: all else that the sweep sets in it, and its value of the parameter.
struct LinePlace {
  std::string line;
  std::optional<double> value;  ///< none: it is no number, and the case stands alone
};

struct Start {
  std::size_t place = 0;                 ///< index of the case
  std::optional<std::size_t> neighbour;  ///< index of the one whose end it starts from
};

/// All places, each after its neighbour: line by line in the order in which they first appear. Places of the
/// same line and value are one case and have one neighbour.
[[nodiscard]] std::vector<Start> start_order(const std::vector<LinePlace>& places, bool from_largest);

/// Why a case with these filled physics cannot start from a checkpoint of one with those: its grid, box or
/// what the solid carries is another. One mistake each.
[[nodiscard]] std::vector<Mistake> neighbour_mistakes(const nlohmann::json& physics,
                                                      const nlohmann::json& neighbour);

}  // namespace softwall::campaign
