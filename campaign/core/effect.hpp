#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "solver/case/bad_input.hpp"

/// What a campaign file may say without effect. It is refused rather than passed over: whoever wrote it
/// expects something of it.
namespace softwall::campaign {

/// Why statistics of such a case could never be had, although it would be computed to its end. filled: a case
/// document with all defaults, free of other mistakes. window_start: of its averages, h/U_b.
[[nodiscard]] std::optional<Mistake> never_sampled(const nlohmann::json& filled, double window_start);

/// Members of these filled physics that change no result, as the others are; by their pointers.
[[nodiscard]] std::vector<std::string> members_without_effect(const nlohmann::json& physics);

/// Counts what each member of "exclude" has excluded.
class ExclusionUse {
 public:
  explicit ExclusionUse(const nlohmann::json& exclusions);

  /// Whether these filled physics have all values of one of the exclusions, set by the sweep or not.
  bool excludes(const nlohmann::json& physics);
  /// One mistake for each exclusion that matched nothing; with the nearest value there is, where a number is
  /// meant that is written with other digits or as text.
  [[nodiscard]] std::vector<Mistake> unused() const;

 private:
  struct Value {
    std::string name;                      ///< as written
    nlohmann::json::json_pointer pointer;  ///< inside "physics"
    nlohmann::json wanted;
    std::optional<nlohmann::json> nearest;  ///< of the values met, when none was equal
    bool met = false;
  };
  struct Exclusion {
    std::vector<Value> values;
    bool used = false;
  };
  static bool matches(Exclusion& exclusion, const nlohmann::json& physics);
  std::vector<Exclusion> exclusions_;
};

}  // namespace softwall::campaign
