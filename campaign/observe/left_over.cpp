#include "campaign/observe/left_over.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "campaign/core/label.hpp"
#include "campaign/core/parameters.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/removed_directories.hpp"
#include "campaign/observe/run_reports.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/json_text.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

std::optional<CampaignCase> case_in(const std::filesystem::path& folder, const std::string& directory) {
  try {
    CampaignCase found;
    found.directory = directory;
    found.definition = read_case(run_files(folder, found).case_file());
    found.definition.label = label_in_directory(directory, found.definition.id);
    found.precursor_id = found.definition.physics.initial.precursor;
    const auto summary = read_summary(run_files(folder, found), found.definition.id);
    if (summary && summary->ranks > 0) found.ranks = summary->ranks;
    return found;
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

std::map<std::string, json> flat_physics(const Case& definition) {
  std::map<std::string, json> members;
  const json physics = to_json(definition).at("physics").flatten();
  for (const auto& [pointer, value] : physics.items()) members[pointer] = value;
  return members;
}

/// "/statistics/start_time" as "statistics.start_time".
std::string dotted(const std::string& pointer) {
  std::string name = pointer.substr(1);
  std::ranges::replace(name, '/', '.');
  return name;
}

std::string value_of(const std::map<std::string, json>& members, const std::string& pointer) {
  const auto found = members.find(pointer);
  return found == members.end() ? "none" : found->second.dump();
}

std::vector<std::string> differences(const std::map<std::string, json>& was,
                                     const std::map<std::string, json>& is) {
  std::set<std::string> pointers;
  for (const auto& [pointer, value] : was) pointers.insert(pointer);
  for (const auto& [pointer, value] : is) pointers.insert(pointer);
  const bool from_neighbour = value_of(is, "/initial/type") == "\"neighbour\"";
  const std::string other_start = from_neighbour ? "another neighbour" : "another precursor";
  std::vector<std::string> found;
  for (const std::string& pointer : pointers) {
    const std::string before = value_of(was, pointer), now = value_of(is, pointer);
    if (before == now) continue;
    const bool start = pointer == "/initial/precursor";
    found.push_back(start ? other_start : dotted(pointer) + " " + before + " instead of " + now);
  }
  return found;
}

/// The values of a case for what varies among the cases of its kind now: what varied when it was asked for
/// stands in no folder.
std::string varied_as_in(const Campaign& campaign, const CampaignCase& left_over) {
  const auto like = std::ranges::find_if(campaign.cases, [&](const CampaignCase& one) {
    return one.is_precursor == left_over.is_precursor && one.varied != "{}";
  });
  if (like == campaign.cases.end()) return "{}";
  const json physics = normalised(to_json(left_over.definition).at("physics"));
  auto values = nlohmann::ordered_json::object();
  const auto varied = nlohmann::ordered_json::parse(like->varied);
  for (const auto& [name, value] : varied.items()) {
    const Parameter* const parameter = find_parameter(name);
    if (parameter != nullptr && physics.contains(parameter->pointer))
      values[name] = physics.at(parameter->pointer);
  }
  return values.dump();
}

/// Below "cases", those that no case of the campaign has, in the order of their names.
std::vector<std::string> directories_of_nobody(const Campaign& campaign,
                                               const std::filesystem::path& folder) {
  std::set<std::string> taken;
  for (const CampaignCase& one : campaign.cases) taken.insert(one.directory);
  std::vector<std::string> found;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "cases", none)) {
    std::string directory = "cases/" + entry.path().filename().string();
    if (!taken.contains(directory) && entry.is_directory(none) && !is_being_removed(entry.path()))
      found.push_back(std::move(directory));
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

std::vector<CampaignCase> left_over_cases(const Campaign& campaign, const std::filesystem::path& folder) {
  std::set<std::string> ids, precursors, starting;
  const auto note_start = [&](const CampaignCase& one) {
    starting.insert(one.precursor_id);
    if (one.definition.physics.initial.type == InitialType::kPrecursor) precursors.insert(one.precursor_id);
  };
  for (const CampaignCase& one : campaign.cases) {
    ids.insert(one.definition.id);
    note_start(one);
  }
  std::vector<CampaignCase> found;
  for (const std::string& directory : directories_of_nobody(campaign, folder)) {
    auto one = case_in(folder, directory);
    if (!one || ids.contains(one->definition.id)) continue;
    note_start(*one);
    found.push_back(std::move(*one));
  }
  for (CampaignCase& one : found) {
    one.is_precursor = precursors.contains(one.definition.id);
    one.starts_others = starting.contains(one.definition.id);
    if (!one.starts_others) one.until = campaign.until;
    one.varied = varied_as_in(campaign, one);
  }
  std::ranges::sort(found, [](const CampaignCase& a, const CampaignCase& b) {
    return std::pair(!a.is_precursor, a.directory) < std::pair(!b.is_precursor, b.directory);
  });
  return found;
}

std::vector<std::string> directories_without_a_case(const Campaign& campaign,
                                                    const std::filesystem::path& folder) {
  std::vector<std::string> found = directories_of_nobody(campaign, folder);
  std::erase_if(found, [&](const std::string& directory) { return case_in(folder, directory).has_value(); });
  return found;
}

std::string why_left_over(const CampaignCase& left_over, const Campaign& campaign) {
  constexpr std::size_t kMostShown = 4;
  const auto was = flat_physics(left_over.definition);
  const CampaignCase* nearest = nullptr;
  std::vector<std::string> fewest;
  for (const CampaignCase& one : campaign.cases) {
    if (one.is_precursor != left_over.is_precursor) continue;
    auto found = differences(was, flat_physics(one.definition));
    if (nearest != nullptr && found.size() >= fewest.size()) continue;
    nearest = &one;
    fewest = std::move(found);
  }
  if (nearest == nullptr) return "";
  std::string text = "like " + nearest->definition.label + ", but ";
  for (std::size_t i = 0; i < std::min(fewest.size(), kMostShown); ++i)
    text += (i > 0 ? ", " : "") + fewest[i];
  return fewest.size() > kMostShown ? text + ", ..." : text;
}

}  // namespace softwall::campaign
