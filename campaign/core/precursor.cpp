#include "campaign/core/precursor.hpp"

#include <string>
#include <vector>

namespace softwall::campaign {
namespace {

using nlohmann::json;

bool concerns_precursor(const std::string& pointer) {
  return pointer == "/reynolds" || pointer == "/domain/length_x" || pointer == "/domain/length_z" ||
         pointer == "/initial/seed" || pointer == "/initial/amplitude" ||
         (pointer.starts_with("/grid/") && pointer != "/grid/ny_solid");
}

void remove_planes_of_the_layer(json& run) {
  constexpr double kRigidHeight = 2;
  if (!run.contains("planes") || !run.at("planes").contains("y")) return;
  auto heights = run.at("planes").at("y").get<std::vector<double>>();
  std::erase_if(heights, [](double y) { return y > kRigidHeight; });
  run["planes"]["y"] = heights;
}

}  // namespace

Point shared_with_precursor(Point point) {
  std::erase_if(point, [](const auto& item) { return !concerns_precursor(item.first); });
  return point;
}

json precursor_document(json common, const json& own, const Point& shared) {
  json& physics = common.at("physics");
  put(shared, physics);
  physics["flow"] = "rigid_channel";
  physics.erase("solid");
  physics["grid"].erase("ny_solid");
  if (physics.contains("domain")) physics["domain"].erase("layer_height");
  json& run = common.at("run");
  remove_planes_of_the_layer(run);
  for (const auto& [key, value] : own.items()) (key == "run" ? run : physics[key]).merge_patch(value);
  return common;
}

}  // namespace softwall::campaign
