#include "campaign/core/case_mistakes.hpp"

#include <algorithm>

namespace softwall::campaign {
namespace {

constexpr std::size_t kLabelsShown = 3;

std::string concerned(const std::vector<std::string>& labels) {
  std::string text = " (case ";
  const std::size_t shown = std::min(labels.size(), kLabelsShown);
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + labels[i];
  if (labels.size() > shown) text += " and " + std::to_string(labels.size() - shown) + " more";
  return text + ")";
}

}  // namespace

void CaseMistakes::add(const std::string& label, const std::string& prefix, std::vector<Mistake> mistakes) {
  for (auto& mistake : mistakes) {
    mistake.where = prefix + mistake.where;
    const auto [known, is_new] =
        index_.emplace(mistake.where + "\n" + mistake.given + "\n" + mistake.allowed, told_.size());
    if (is_new) told_.push_back({std::move(mistake), {}});
    auto& labels = told_[known->second].labels;
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
  }
}

std::vector<Mistake> CaseMistakes::all(std::size_t cases) const {
  std::vector<Mistake> all;
  for (const auto& told : told_) {
    Mistake mistake = told.mistake;
    if (told.labels.size() < cases) mistake.allowed += concerned(told.labels);
    all.push_back(std::move(mistake));
  }
  return all;
}

void CaseMistakes::throw_if_any(const std::string& source, std::size_t cases) const {
  if (!told_.empty()) throw BadInput(source, all(cases));
}

}  // namespace softwall::campaign
