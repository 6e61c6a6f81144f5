#include "campaign/observe/case_directories.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <unordered_set>

#include "campaign/core/label.hpp"
#include "campaign/observe/removed_directories.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {

namespace {

/// Those whose digits no case of the campaign has, in the order of their names: which of several equally good
/// ones serves must not depend on chance.
std::set<std::string> directories_of_others(const CaseDirectories& directories,
                                            const std::unordered_set<std::string>& digits_of_campaign) {
  std::set<std::string> others;
  for (const auto& [digits, directory] : directories)
    if (!digits_of_campaign.contains(digits)) others.insert(directory);
  return others;
}

}  // namespace

CaseDirectories existing_directories(const std::filesystem::path& folder) {
  CaseDirectories found;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "cases", none)) {
    const std::string name = entry.path().filename();
    if (name.size() <= kIdDigits + 1 || name[name.size() - kIdDigits - 1] != '-') continue;
    if (entry.is_directory(none) && !is_being_removed(entry.path()))
      found.emplace(name.substr(name.size() - kIdDigits), "cases/" + name);
  }
  return found;
}

ExistingCases existing_cases(const Campaign& campaign, const std::filesystem::path& folder,
                             const CaseDirectories& directories) {
  std::unordered_set<std::string> digits;
  for (const CampaignCase& one : campaign.cases) digits.insert(one.definition.id.substr(0, kIdDigits));
  const auto has_directory = [&](const std::string& each) { return directories.contains(each); };
  ExistingCases existing;
  if (std::ranges::all_of(digits, has_directory)) return existing;
  for (const CampaignCase& one : campaign.cases) {
    if (has_directory(one.definition.id.substr(0, kIdDigits)))
      existing.add(to_json(one.definition).at("physics"));
  }
  for (const std::string& directory : directories_of_others(directories, digits)) {
    try {
      existing.add(to_json(read_case(RunFiles{folder / directory}.case_file())).at("physics"));
    } catch (const BadInput&) {
      continue;  // it tells nothing
    }
  }
  return existing;
}

}  // namespace softwall::campaign
