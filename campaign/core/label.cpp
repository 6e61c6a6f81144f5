#include "campaign/core/label.hpp"

#include <cctype>
#include <nlohmann/json.hpp>

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

}  // namespace

std::string safe_label(const std::string& text) {
  std::string label;
  for (const char c : text.substr(0, kLongestLabel)) label += is_safe(c) ? c : '-';
  const bool hidden_or_option = label.empty() || label.front() == '.' || label.front() == '-';
  if (hidden_or_option) label = ("x" + label).substr(0, kLongestLabel);
  return label;
}

std::string label_of(const std::vector<std::pair<std::string, nlohmann::json>>& parameters) {
  std::string label;
  for (const auto& [name, value] : parameters) {
    const std::string text = value.is_string() ? value.get<std::string>() : canonical_text(value);
    label += (label.empty() ? "" : "_") + short_name(name) + "=" + text;
  }
  return safe_label(label);
}

std::string case_directory(const std::string& label, const std::string& case_id) {
  return "cases/" + safe_label(label) + "-" + case_id.substr(0, 8);
}

}  // namespace softwall::campaign
