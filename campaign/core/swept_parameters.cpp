#include "campaign/core/swept_parameters.hpp"

#include <algorithm>

#include "campaign/core/label.hpp"

namespace softwall::campaign {

using nlohmann::json;

SweptParameters::SweptParameters(const std::vector<Point>& points, const Derivation& derivation)
    : pointers_(set_pointers(points, derivation)), places_(pointers_.begin(), pointers_.end()) {
  const auto derived = derivation.pointers();
  for (const std::string& pointer : pointers_)
    derived_.push_back(std::ranges::find(derived, pointer) != derived.end());
}

bool SweptParameters::contains(const std::string& pointer) const {
  return std::ranges::binary_search(pointers_, pointer);
}

std::vector<bool> SweptParameters::not_derived() const {
  std::vector<bool> chosen = derived_;
  chosen.flip();
  return chosen;
}

std::vector<json> SweptParameters::values_of(const json& physics) const {
  std::vector<json> values;
  for (const auto& place : places_) values.push_back(physics.contains(place) ? physics.at(place) : json());
  return values;
}

std::vector<std::pair<std::string, json>> SweptParameters::named(const std::vector<json>& values,
                                                                 const std::vector<bool>& chosen) const {
  std::vector<std::pair<std::string, json>> parameters;
  for (std::size_t i = 0; i < size(); ++i)
    if (chosen[i] && !values[i].is_null()) parameters.emplace_back(places_[i].back(), values[i]);
  return parameters;
}

std::string SweptParameters::label(const std::vector<json>& values) const {
  return label_of(named(values, not_derived()));
}

}  // namespace softwall::campaign
