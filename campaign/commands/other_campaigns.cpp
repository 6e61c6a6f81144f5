#include "campaign/commands/other_campaigns.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> other_json_files(const LoadedCampaign& loaded) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(loaded.folder, none)) {
    if (entry.path().extension() == ".json" && entry.path() != loaded.file && entry.is_regular_file(none))
      found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

/// Whoever is just writing one leaves it in a state that is no JSON.
bool seems_to_be_a_campaign(const fs::path& file) {
  std::ifstream in(file);
  const auto document = nlohmann::json::parse(in, nullptr, false);
  return document.is_discarded() || (document.is_object() && document.contains("physics"));
}

}  // namespace

OtherCampaigns other_campaigns(const LoadedCampaign& loaded) {
  OtherCampaigns others;
  for (const fs::path& file : other_json_files(loaded)) {
    const std::string name = file.filename().string();
    try {
      for (const CampaignCase& one : load_campaign(file).campaign.cases)
        others.asked_by.emplace(one.definition.id, name);
    } catch (const BadInput&) {
      if (seems_to_be_a_campaign(file)) others.unreadable.push_back(name);
    }
  }
  return others;
}

}  // namespace softwall::campaign
