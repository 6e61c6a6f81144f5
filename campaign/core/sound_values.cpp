#include "campaign/core/sound_values.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "solver/case/case_schema.hpp"

namespace softwall::campaign {
namespace {

std::string members_of(const Point& point) {
  std::string members;
  for (const auto& [pointer, value] : point) members += pointer + "\n";
  return members;
}

}  // namespace

bool SoundValues::covers(const Point& point) {
  return sound_.contains(members_of(point)) && std::ranges::all_of(point, [&](const auto& item) {
           return schema_of(item.first).mistakes(item.second).empty();
         });
}

void SoundValues::note_sound(const Point& point) { sound_.insert(members_of(point)); }

const JsonSchema& SoundValues::schema_of(const std::string& pointer) {
  const auto known = schemas_.find(pointer);
  if (known != schemas_.end()) return known->second;
  const nlohmann::json::json_pointer place("/physics" + pointer);
  return schemas_.emplace(pointer, case_schema().part(place)->dump()).first->second;
}

}  // namespace softwall::campaign
