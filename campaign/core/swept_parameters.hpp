#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "campaign/core/derive.hpp"
#include "campaign/core/sweep.hpp"

namespace softwall::campaign {

/// The parameters that the points of a sweep set, or that are derived from them, in alphabetical order; and
/// what a case has of each.
class SweptParameters {
 public:
  SweptParameters(const std::vector<Point>& points, const Derivation& derivation);

  [[nodiscard]] std::size_t size() const { return pointers_.size(); }
  /// Inside "physics".
  [[nodiscard]] const std::string& pointer(std::size_t i) const { return pointers_[i]; }
  [[nodiscard]] bool contains(const std::string& pointer) const;
  [[nodiscard]] bool is_derived(std::size_t i) const { return derived_[i]; }
  /// A choice of those that the sweep itself sets.
  [[nodiscard]] std::vector<bool> not_derived() const;

  /// One a parameter; null: these physics have no such member.
  [[nodiscard]] std::vector<nlohmann::json> values_of(const nlohmann::json& physics) const;
  /// Those chosen, by the parameters' names, without members that are not there.
  [[nodiscard]] std::vector<std::pair<std::string, nlohmann::json>> named(
      const std::vector<nlohmann::json>& values, const std::vector<bool>& chosen) const;
  /// "G=1_mu=10": all that the sweep sets, for messages.
  [[nodiscard]] std::string label(const std::vector<nlohmann::json>& values) const;

 private:
  std::vector<std::string> pointers_;
  std::vector<nlohmann::json::json_pointer> places_;  ///< the same, to look members up by
  std::vector<bool> derived_;
};

}  // namespace softwall::campaign
