#include "solver/case/bad_input.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace softwall {
namespace {

constexpr std::size_t kMistakesShown = 50;

std::string line(const Mistake& mistake) {
  std::string text = "\n  ";
  if (!mistake.where.empty()) text += mistake.where + ": ";
  text += mistake.given;
  if (!mistake.allowed.empty()) text += "; " + mistake.allowed;
  return text;
}

std::string report(const std::string& source, const std::vector<Mistake>& mistakes) {
  std::string text = source + ":";
  const std::size_t shown = std::min(mistakes.size(), kMistakesShown);
  for (std::size_t i = 0; i < shown; ++i) text += line(mistakes[i]);
  if (shown < mistakes.size()) text += "\n  and " + std::to_string(mistakes.size() - shown) + " more";
  return text;
}

}  // namespace

BadInput::BadInput(const std::string& source_name, std::vector<Mistake> all)
    : std::runtime_error(report(source_name, all)), source(source_name), mistakes(std::move(all)) {}

std::string printable_excerpt(std::string_view text, std::size_t limit) {
  const bool cut = text.size() > limit;
  const nlohmann::json quoted = std::string(text.substr(0, limit));
  const bool ascii_only = true;
  const std::string dumped = quoted.dump(-1, ' ', ascii_only, nlohmann::json::error_handler_t::replace);
  return dumped.substr(1, dumped.size() - 2) + (cut ? "..." : "");
}

}  // namespace softwall
