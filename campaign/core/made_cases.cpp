#include "campaign/core/made_cases.hpp"

#include <algorithm>

#include "campaign/core/effect.hpp"
#include "campaign/core/label.hpp"
#include "solver/case/case_id.hpp"
#include "solver/case/case_json.hpp"
#include "solver/case/json_text.hpp"

namespace softwall::campaign {

using nlohmann::json;

void MadeCases::reserve(std::size_t number) {
  list_.reserve(number);
  values_.reserve(number);
}

void MadeCases::add(CampaignCase made, std::vector<json> values) {
  const auto [known, is_new] = index_.emplace(made.definition.id, list_.size());
  if (!is_new) return note_merged(values_[known->second], values);
  list_.push_back(std::move(made));
  values_.push_back(std::move(values));
}

void MadeCases::note_idle(json physics, const std::vector<json>& values) {
  std::vector<json::json_pointer> idle;
  for (const std::string& pointer : members_without_effect(physics))
    if (swept_.contains(pointer)) idle.emplace_back(pointer);
  if (idle.empty()) return;
  for (const auto& pointer : idle) {
    json& object = physics.at(pointer.parent_pointer());
    if (object.is_object()) object.erase(pointer.back());
  }
  const auto [known, is_new] = by_effect_.emplace(case_id(physics), list_.size());
  if (!is_new && known->second < values_.size()) note_merged(values_[known->second], values);
}

/// Two points of the sweep are one case although they differ: what they differ in has no effect.
void MadeCases::note_merged(const std::vector<json>& first, const std::vector<json>& second) {
  for (std::size_t i = 0; i < swept_.size(); ++i) {
    const std::string& pointer = swept_.pointer(i);
    if (first[i] == second[i] || swept_.is_derived(i) || merged_.contains(pointer)) continue;
    merged_[pointer] = {"/sweep: " + pointer.substr(1), quoted(first[i]) + " and " + quoted(second[i]),
                        "give the same case: this parameter has no effect here, leave it out of the sweep"};
  }
}

std::vector<bool> MadeCases::varying(bool also_the_same) const {
  std::vector<bool> varies(swept_.size(), false);
  for (const auto& values : values_)
    for (std::size_t i = 0; i < swept_.size(); ++i) varies[i] = varies[i] || values[i] != values_[0][i];
  const bool single = std::ranges::find(varies, true) == varies.end();
  return single && also_the_same ? swept_.not_derived() : varies;
}

void MadeCases::name(const std::string& first) {
  const auto chosen = varying(first.empty());
  for (std::size_t c = 0; c < list_.size(); ++c) {
    const auto parameters = swept_.named(values_[c], chosen);
    std::string label = parameters.empty() ? "" : label_of(parameters);
    if (!first.empty()) label = first + (label.empty() ? "" : "_" + label);
    if (label.empty()) label = name_of(list_[c].definition.physics.flow);
    list_[c].definition.label = label;
    nlohmann::ordered_json varied = nlohmann::ordered_json::object();
    for (const auto& [parameter, value] : parameters) varied[parameter] = value;
    list_[c].varied = varied.dump();
  }
}

}  // namespace softwall::campaign
