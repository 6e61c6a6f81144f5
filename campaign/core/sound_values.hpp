#pragma once

#include <map>
#include <set>
#include <string>

#include "campaign/core/sweep.hpp"
#include "solver/case/json_schema.hpp"

namespace softwall::campaign {

/// Decides by the values that a point sets whether its case is valid by the schema, once another point that
/// sets the same members has shown that the rest is. The schema judges every member by itself, so this is
/// what it would say of the whole document, which differs in these values alone.
class SoundValues {
 public:
  [[nodiscard]] bool covers(const Point& point);
  void note_sound(const Point& point);

 private:
  [[nodiscard]] const JsonSchema& schema_of(const std::string& pointer);

  std::set<std::string> sound_;  ///< the members set by points whose case was sound
  std::map<std::string, JsonSchema> schemas_;
};

}  // namespace softwall::campaign
