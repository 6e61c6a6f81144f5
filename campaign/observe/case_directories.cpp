#include "campaign/observe/case_directories.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "solver/case/bad_input.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {

namespace {

std::map<std::string, std::string> directories_in_order(
    const std::unordered_multimap<std::string, std::string>& by_digits) {
  std::map<std::string, std::string> in_order;
  for (const auto& [digits, directory] : by_digits) in_order.emplace(directory, digits);
  return in_order;
}

}  // namespace

std::unordered_multimap<std::string, std::string> existing_directories(const std::filesystem::path& folder) {
  std::unordered_multimap<std::string, std::string> found;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "cases", none)) {
    const std::string name = entry.path().filename();
    if (name.size() <= kIdDigits + 1 || name[name.size() - kIdDigits - 1] != '-') continue;
    if (entry.is_directory(none)) found.emplace(name.substr(name.size() - kIdDigits), "cases/" + name);
  }
  return found;
}

ExistingCases existing_cases(const Campaign& campaign, const std::filesystem::path& folder) {
  auto others = existing_directories(folder);
  const auto has_directory = [&](const CampaignCase& one) {
    return others.erase(one.definition.id.substr(0, kIdDigits)) > 0;
  };
  const auto with_directory = std::ranges::count_if(campaign.cases, has_directory);
  ExistingCases existing;
  if (with_directory == std::ssize(campaign.cases)) return existing;
  // In the order of their names: which of several equally good ones serves must not depend on chance.
  for (const auto& [directory, digits] : directories_in_order(others)) {
    try {
      existing.add(to_json(read_case(RunFiles{folder / directory}.case_file())).at("physics"));
    } catch (const BadInput&) {
      continue;  // it tells nothing
    }
  }
  return existing;
}

}  // namespace softwall::campaign
