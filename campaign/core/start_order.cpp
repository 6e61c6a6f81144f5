#include "campaign/core/start_order.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

#include <nlohmann/json.hpp>

#include "campaign/core/parameters.hpp"
#include "solver/case/json_schema.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

/// What a checkpoint has in common with the case that it starts.
const std::array<std::string, 5> kSharedMembers = {"/grid", "/domain", "/precision", "/solid/formulation",
                                                   "/solid/interface"};

bool is_shared(const std::string& pointer) {
  return std::ranges::any_of(kSharedMembers, [&](const std::string& member) {
    return pointer == member || pointer.starts_with(member + "/");
  });
}

}  // namespace

std::vector<Mistake> start_from_mistakes(const json& start_from, const json& until, const std::string& flow) {
  std::vector<Mistake> mistakes;
  if (start_from.is_null()) return mistakes;
  if (flow != "elastic_wall" && flow != "rigid_channel")
    mistakes.push_back({"/start_from", "given", "the cases of flow \"" + flow + "\" start by themselves"});
  if (!until.empty())
    mistakes.push_back({"/until", until.dump(),
                        "not together with start_from: a case that others start from runs to its end time"});
  return mistakes;
}

std::optional<StartFrom> start_from_of(const json& start_from) {
  if (start_from.is_null()) return std::nullopt;
  const std::string nearest = start_from.at("nearest");
  return StartFrom{find_parameter(nearest)->pointer.to_string(), start_from.at("first") == "largest"};
}

std::string words_of(const StartFrom& start_from) {
  return std::string(start_from.from_largest ? "largest " : "smallest ") +
         json::json_pointer(start_from.nearest).back();
}

std::vector<Start> start_order(const std::vector<LinePlace>& places, bool from_largest) {
  std::unordered_map<std::string, std::size_t> numbers;
  std::vector<std::vector<std::size_t>> lines;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string own = places[i].value ? "in " + places[i].line : "alone " + std::to_string(i);
    const auto [line, is_new] = numbers.emplace(own, lines.size());
    if (is_new) lines.emplace_back();
    lines[line->second].push_back(i);
  }
  std::vector<Start> order;
  for (auto& line : lines) {
    std::ranges::stable_sort(line, [&](std::size_t a, std::size_t b) {
      return from_largest ? places[a].value > places[b].value : places[a].value < places[b].value;
    });
    std::optional<std::size_t> neighbour;
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (k > 0 && places[line[k]].value != places[line[k - 1]].value) neighbour = line[k - 1];
      order.push_back({line[k], neighbour});
    }
  }
  return order;
}

std::vector<Mistake> neighbour_mistakes(const json& physics, const json& neighbour) {
  std::vector<Mistake> mistakes;
  const json leaves = physics.flatten();
  for (const auto& [pointer, value] : leaves.items()) {
    const json::json_pointer place(pointer);
    if (!is_shared(pointer) || !neighbour.contains(place) || neighbour.at(place) == value) continue;
    mistakes.push_back({"/start_from: " + pointer.substr(1), quoted(value),
                        "must be that of the case that it starts from, " + quoted(neighbour.at(place))});
  }
  return mistakes;
}

}  // namespace softwall::campaign
