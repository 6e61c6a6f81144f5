#include "solver/case/case_checks.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "solver/case/wall_normal_grid.hpp"

namespace softwall {
namespace {

using nlohmann::json;

/// Gives members that the schema found in order, and nothing for all others.
class SoundMembers {
 public:
  SoundMembers(const json& document, const std::vector<Mistake>& known)
      : document_(document), known_(known) {}

  template <typename T>
  [[nodiscard]] std::optional<T> get(const std::string& pointer) const {
    const json* value = find(pointer);
    return value ? std::optional<T>(value->get<T>()) : std::nullopt;
  }

  [[nodiscard]] const json* find(const std::string& pointer) const {
    const json::json_pointer place(pointer);
    if (spoilt(pointer) || !document_.contains(place)) return nullptr;
    return &document_.at(place);
  }

 private:
  /// True when a mistake lies at the member or at one that encloses it.
  [[nodiscard]] bool spoilt(const std::string& pointer) const {
    return std::any_of(known_.begin(), known_.end(), [&](const Mistake& mistake) {
      return pointer == mistake.where || pointer.starts_with(mistake.where + "/");
    });
  }

  const json& document_;
  const std::vector<Mistake>& known_;
};

void check_layer_cells(const SoundMembers& members, std::vector<Mistake>& mistakes) {
  const auto nx = members.get<int>("/physics/grid/nx");
  const auto ny_fluid = members.get<int>("/physics/grid/ny_fluid");
  const auto ny_solid = members.get<int>("/physics/grid/ny_solid");
  const auto stretching = members.get<double>("/physics/grid/stretching");
  const auto layer_height = members.get<double>("/physics/domain/layer_height");
  if (!ny_solid) return;
  if (*ny_solid < 4) {
    mistakes.push_back(
        {"/physics/grid/ny_solid", std::to_string(*ny_solid), "an elastic wall needs at least 4"});
    return;
  }
  if (!ny_fluid || !stretching || !layer_height) return;
  const GridSpec grid{nx.value_or(4), *ny_fluid, *ny_solid, 4, *stretching};
  if (auto problem = interface_spacing_problem(grid, *layer_height); !problem.empty())
    mistakes.push_back({"/physics/grid/ny_solid", std::to_string(*ny_solid), std::move(problem)});
}

void check_elastic(const SoundMembers& members, const json& filled, std::vector<Mistake>& mistakes) {
  if (!filled.contains(json::json_pointer("/physics/solid")))
    mistakes.push_back(
        {"/physics/solid", "missing", "flow \"elastic_wall\" needs an object with at least G"});
  check_layer_cells(members, mistakes);
}

void check_rigid(const SoundMembers& members, const json& filled, std::vector<Mistake>& mistakes) {
  if (filled.contains(json::json_pointer("/physics/solid")))
    mistakes.push_back({"/physics/solid", "given", "flow \"rigid_channel\" has none: leave it out"});
  const auto ny_solid = members.get<int>("/physics/grid/ny_solid");
  if (ny_solid.value_or(0) != 0)
    mistakes.push_back(
        {"/physics/grid/ny_solid", std::to_string(*ny_solid), "must be 0 for flow \"rigid_channel\""});
}

void check_initial(const SoundMembers& members, std::vector<Mistake>& mistakes) {
  const auto type = members.get<std::string>("/physics/initial/type");
  const auto precursor = members.get<std::string>("/physics/initial/precursor");
  if (!type || !precursor) return;
  if (*type == "precursor" && precursor->empty())
    mistakes.push_back(
        {"/physics/initial/precursor", "empty", "initial type \"precursor\" needs the precursor's case id"});
}

}  // namespace

std::vector<Mistake> case_cross_checks(const json& filled, const std::vector<Mistake>& known) {
  const SoundMembers members(filled, known);
  std::vector<Mistake> mistakes;
  const auto flow = members.get<std::string>("/physics/flow");
  if (flow == "elastic_wall") check_elastic(members, filled, mistakes);
  if (flow == "rigid_channel") check_rigid(members, filled, mistakes);
  check_initial(members, mistakes);
  return mistakes;
}

}  // namespace softwall
