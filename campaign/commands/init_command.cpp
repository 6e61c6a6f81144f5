#include <iostream>
#include <nlohmann/json.hpp>

#include "campaign/commands/commands.hpp"
#include "campaign/core/parameters.hpp"
#include "campaign/core/spec.hpp"
#include "campaign/store/result_table.hpp"
#include "campaign/store/text_width.hpp"
#include "campaign/system/shell_words.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/case/bad_input.hpp"

/// A first campaign for someone who has none: small enough to see its end the same minute, with every key
/// that most campaigns change.
namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// NAME stands for the name of the folder as a JSON text.
constexpr const char* kFirstCampaign = R"({
  "format": 1,
  "name": NAME,
  "description": "What this campaign is for.",
  "physics": {
    "reynolds": 2800,
    "domain": {"length_x": 6, "length_z": 3, "layer_height": 0.5},
    "grid": {"nx": 32, "ny_fluid": 32, "ny_solid": 8, "nz": 32, "stretching": 1.0},
    "precision": "single",
    "statistics": {"start_time": 30, "block_length": 5}
  },
  "precursor": {"statistics": {"start_time": 60}, "run": {"end_time": 200}},
  "sweep": {"grid": {"G": [2, 0.5, 0.25], "viscosity_ratio": [1]}},
  "run": {"end_time": 130, "field_interval": 0},
  "execution": {"ranks": 1, "cores": 2}
}
)";

/// The name of the folder as a campaign may have it: harmless, and not too long.
std::string name_after(const fs::path& folder) {
  constexpr std::size_t kLongest = 80;
  const std::string name = shortened(printable(fs::weakly_canonical(folder).filename().string()), kLongest);
  return name.empty() ? "campaign" : name;
}

std::string text_for(const fs::path& folder) {
  std::string text = kFirstCampaign;
  const std::string placeholder = "NAME";
  text.replace(text.find(placeholder), placeholder.size(), json(name_after(folder)).dump());
  return text;
}

/// Where the schema describes what stands there: a swept parameter is one of "physics".
json::json_pointer described_at(const json::json_pointer& at) {
  if (at.empty() || at.parent_pointer() != json::json_pointer("/sweep/grid")) return at;
  const Parameter* parameter = find_parameter(at.back());
  return parameter == nullptr ? at : json::json_pointer("/physics") / parameter->pointer;
}

/// One row a key: where it stands, what was written, what the schema says of it.
void explain(const json& node, const json::json_pointer& at, ResultTable& table) {
  if (node.is_object()) {
    for (const auto& [key, member] : node.items()) explain(member, at / key, table);
    return;
  }
  const json* schema = campaign_schema().part(described_at(at));
  if (schema == nullptr || !schema->contains("description")) return;
  std::string place;
  for (json::json_pointer rest = at; !rest.empty(); rest.pop_back())
    place = rest.back() + (place.empty() ? "" : ".") + place;
  table.rows.push_back({place, node.dump(), schema->at("description").get<std::string>()});
}

}  // namespace

ExitStatus begin_campaign(const fs::path& folder) {
  const fs::path file = folder / "campaign.json";
  std::error_code unreadable;
  if (fs::exists(file, unreadable))
    throw BadInput(folder.string(), {{"", "has a campaign.json already", "name a new folder"}});
  const std::string text = text_for(folder);
  fs::create_directories(folder);
  write_atomically(file, text);

  std::cout << "Wrote " << file.string()
            << ": a rigid channel, and three walls that start from its turbulence.\n\n";
  ResultTable table{{"key", "value", "meaning"}, {}};
  explain(json::parse(text), json::json_pointer(), table);
  write_table(std::cout, table, TableFormat::kText);
  std::cout
      << "\nEvery other key has a default; schemas/KEYS.md lists them all. Change what you like, then:\n"
      << "  " << softwall_command("plan", folder) << "    # what it would run, and what that costs\n"
      << "  " << softwall_command("run", folder) << "\n";
  return ExitStatus::kDone;
}

}  // namespace softwall::campaign
