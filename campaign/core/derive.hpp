#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "campaign/core/expression.hpp"
#include "campaign/core/parameters.hpp"
#include "campaign/core/sweep.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/json_schema.hpp"

/// Values of a case that follow from its other values: the object "derive" of a campaign file. What is
/// derived is put beside what the sweep sets, before a case is checked and its id is made, so that it cannot
/// be told from a value that was written by hand.
namespace softwall::campaign {

/// What shows before any case is made: expressions that cannot be read, names that are no parameters,
/// parameters that are set in another place as well, values that need each other in a circle. sweep: as
/// filled in by the schema; physics: as written.
[[nodiscard]] std::vector<Mistake> derive_mistakes(const nlohmann::json& derive, const nlohmann::json& sweep,
                                                   const nlohmann::json& physics);

class Derivation {
 public:
  /// Needs a "derive" without mistakes.
  explicit Derivation(const nlohmann::json& derive);

  [[nodiscard]] bool empty() const { return rules_.empty(); }
  /// The parameters derived, inside "physics".
  [[nodiscard]] std::vector<std::string> pointers() const;

  /// Puts the derived values into a point. physics: of its case with all defaults, without what is derived.
  /// What cannot be derived, or is no value that its parameter may have, is told, and the point stays.
  [[nodiscard]] std::vector<Mistake> add_to(Point& point, nlohmann::json physics) const;

  /// Notes which of the derived values this case depends on; with all of them, and all defaults.
  void note_effect(const nlohmann::json& physics);
  /// One mistake for each that none of the cases noted depends on.
  [[nodiscard]] std::vector<Mistake> without_effect() const;

 private:
  struct Rule {
    std::string name;  ///< as written
    std::string text;
    const Parameter* parameter;
    Expression expression;
    JsonSchema allowed;
    bool has_effect = false;
  };
  std::vector<Rule> rules_;  ///< each after those that it needs
};

/// Every parameter that some point sets or that is derived, sorted.
[[nodiscard]] std::vector<std::string> set_pointers(const std::vector<Point>& points,
                                                    const Derivation& derivation);

}  // namespace softwall::campaign
