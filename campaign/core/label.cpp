#include "campaign/core/label.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "solver/case/case_id.hpp"

namespace softwall::campaign {
namespace {

constexpr std::size_t kLongestLabel = 80;

/// The paper's letter where there is one.
std::string short_name(const std::string& parameter) {
  return parameter == "viscosity_ratio" ? "mu" : parameter;
}

bool is_safe(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '=' || c == '-';
}

/// 1e+20 is 1e20: "+" is none of the characters of a label, and "-" would make it another number.
std::string value_text(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  std::string text = canonical_text(value);
  std::erase(text, '+');
  return text;
}

std::string with_id(const std::string& label, const std::string& case_id) {
  return label.substr(0, kLongestLabel - kIdDigits - 1) + "-" + case_id.substr(0, kIdDigits);
}

}  // namespace

std::string safe_label(const std::string& text) {
  std::string label;
  for (const char c : text) label += is_safe(c) ? c : '-';
  const bool hidden_or_option = label.empty() || label.front() == '.' || label.front() == '-';
  return hidden_or_option ? "x" + label : label;
}

std::string label_of(const std::vector<std::pair<std::string, nlohmann::json>>& parameters) {
  std::string label;
  for (const auto& [name, value] : parameters) {
    label += (label.empty() ? "" : "_") + short_name(name) + "=" + value_text(value);
  }
  return label;
}

std::string case_directory(const std::string& label, const std::string& case_id) {
  return "cases/" + label + "-" + case_id.substr(0, kIdDigits);
}

std::string label_in_directory(const std::string& directory, const std::string& case_id) {
  const std::string name = directory.substr(directory.rfind('/') + 1);
  const std::string end = "-" + case_id.substr(0, kIdDigits);
  return name.ends_with(end) ? name.substr(0, name.size() - end.size()) : name;
}

void make_labels_distinct(Campaign& campaign, const std::unordered_set<std::string>& kept) {
  const std::size_t number = campaign.cases.size();
  std::unordered_map<std::string, int> bearers, keepers;
  bearers.reserve(number);
  std::vector<bool> keeps(number);
  for (std::size_t i = 0; i < number; ++i) {
    CampaignCase& one = campaign.cases[i];
    one.definition.label = safe_label(one.definition.label);
    const std::string label = one.definition.label.substr(0, kLongestLabel);
    ++bearers[label];
    keeps[i] = kept.contains(one.definition.id);
    if (keeps[i]) ++keepers[label];
  }
  for (std::size_t i = 0; i < number; ++i) {
    CampaignCase& one = campaign.cases[i];
    std::string& label = one.definition.label;
    const bool is_cut = label.size() > kLongestLabel;
    label.resize(std::min(label.size(), kLongestLabel));
    const bool alone = (keeps[i] ? keepers : bearers).at(label) == 1;
    if (is_cut || !alone) label = with_id(label, one.definition.id);
    if (!keeps[i]) one.directory = case_directory(label, one.definition.id);
  }
}

}  // namespace softwall::campaign
