#include "campaign/commands/other_campaigns.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

/// A campaign file may have any name; one that is called .json may be a link that leads nowhere at present.
bool may_be_a_campaign(const fs::directory_entry& entry) {
  constexpr std::uintmax_t kMostBytes = 64UL << 20;  // of the largest lists of cases, many times over
  std::error_code unreadable;
  if (entry.path().extension() == ".json") return !entry.is_directory(unreadable);
  if (!entry.is_regular_file(unreadable) || entry.file_size(unreadable) > kMostBytes) return false;
  std::ifstream in(entry.path());
  char first = ' ';
  return in >> first && first == '{';  // whoever opens a campaign file finds an object there
}

std::vector<fs::path> other_files(const LoadedCampaign& loaded) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(loaded.folder, none)) {
    if (entry.path() != loaded.file && may_be_a_campaign(entry)) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

/// Whoever is just writing one leaves it in a state that is no JSON, and what cannot be read may be one.
bool seems_to_be_a_campaign(const fs::path& file) {
  std::ifstream in(file);
  const auto document = nlohmann::json::parse(in, nullptr, false);
  if (document.is_discarded()) return file.extension() == ".json";
  return document.is_object() && document.contains("physics");
}

}  // namespace

OtherCampaigns other_campaigns(const LoadedCampaign& loaded) {
  OtherCampaigns others;
  for (const fs::path& file : other_files(loaded)) {
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
