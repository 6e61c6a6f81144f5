#include "solver/case/case_checks.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>

#include "solver/case/interface_mode.hpp"
#include "solver/case/json_schema.hpp"
#include "solver/case/wall_normal_grid.hpp"

namespace softwall {
namespace {

using nlohmann::json;

/// The member at a pointer of plain keys, or null. A json_pointer would be parsed for each question anew.
const json* member_at(const json& document, std::string_view pointer) {
  const json* at = &document;
  while (!pointer.empty() && at) {
    pointer.remove_prefix(1);
    const std::string_view key = pointer.substr(0, pointer.find('/'));
    const auto found = at->find(key);
    at = found != at->end() ? &*found : nullptr;
    pointer.remove_prefix(key.size());
  }
  return at;
}

/// Gives members that the schema found in order, and nothing for all others.
class SoundMembers {
 public:
  SoundMembers(const json& document, const std::vector<Mistake>& known)
      : document_(document), known_(known) {}

  template <typename T>
  [[nodiscard]] std::optional<T> get(std::string_view pointer) const {
    const json* value = find(pointer);
    return value ? std::optional<T>(value->get<T>()) : std::nullopt;
  }

  [[nodiscard]] const json* find(std::string_view pointer) const {
    return spoilt(pointer) ? nullptr : member_at(document_, pointer);
  }

 private:
  /// True when a mistake lies at the member or at one that encloses it.
  [[nodiscard]] bool spoilt(std::string_view pointer) const {
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

/// What only a closed box has.
void check_no_box(const SoundMembers& members, const json& filled, std::vector<Mistake>& mistakes) {
  if (const auto height = members.get<double>("/physics/domain/height"); height && *height != kFluidHeight)
    mistakes.push_back({"/physics/domain/height", quoted(json(*height)), "must be 2 in a channel"});
  if (members.get<std::string>("/physics/time_step/viscosity") == "implicit")
    mistakes.push_back({"/physics/time_step/viscosity", "implicit", "must be \"explicit\" in a channel"});
  if (member_at(filled, "/physics/solid/disc"))
    mistakes.push_back({"/physics/solid/disc", "given", "only a closed box holds one: leave it out"});
}

/// An elastic layer on the upper wall.
void check_layer(const SoundMembers& members, const json& filled, std::vector<Mistake>& mistakes) {
  check_no_box(members, filled, mistakes);
  if (!member_at(filled, "/physics/solid"))
    mistakes.push_back({"/physics/solid", "missing",
                        "flow \"" + members.get<std::string>("/physics/flow").value_or("") +
                            "\" needs an object with at least G"});
  if (members.get<std::string>("/physics/solid/interface") == "mthinc" &&
      members.get<std::string>("/physics/solid/formulation") == "reference_map")
    mistakes.push_back({"/physics/solid/interface", "mthinc",
                        "carries a phi that \"reference_map\" does not have: leave it out"});
  if (members.get<std::string>("/physics/solid/interface") == "height" &&
      members.get<std::string>("/physics/solid/formulation") == "transported_B" &&
      members.get<std::string>("/physics/solid/extension") == "normal")
    mistakes.push_back(
        {"/physics/solid/interface", "height",
         "a height over each column: must be \"mthinc\" or \"weno\" with extension \"normal\""});
  check_layer_cells(members, mistakes);
}

/// The layers of an interface wave, where all that describes them is in order.
std::optional<WaveLayers> layers_of(const SoundMembers& members) {
  const auto reynolds = members.get<double>("/physics/reynolds");
  const auto length = members.get<double>("/physics/domain/length_x");
  const auto thickness = members.get<double>("/physics/domain/layer_height");
  const auto G = members.get<double>("/physics/solid/G");
  const auto ratio = members.get<double>("/physics/solid/viscosity_ratio");
  if (!reynolds || !length || !thickness || !G || !ratio) return std::nullopt;
  return wave_layers(*reynolds, *length, *thickness, *G, *ratio);
}

std::string wave_text(InterfaceMode::Complex rate) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "decay %.10g, frequency %.10g", -rate.real(), rate.imag());
  return text.data();
}

/// The rate must be one of these layers: the mode of another would not turn and decay as it says.
void check_wave_rate(const SoundMembers& members, std::vector<Mistake>& mistakes) {
  constexpr double kTolerance = 1e-6;
  const auto layers = layers_of(members);
  const auto decay = members.get<double>("/physics/wave/decay");
  const auto frequency = members.get<double>("/physics/wave/frequency");
  if (!layers || !decay || !frequency) return;
  const InterfaceMode::Complex given(-*decay, *frequency);
  const auto rate = nearest_rate(*layers, given);
  const bool is_wave = rate && -rate->real() > 0 && rate->imag() > 0;
  if (is_wave && std::abs(*rate - given) <= kTolerance * std::abs(given)) return;
  mistakes.push_back({"/physics/wave", wave_text(given),
                      "not the rate of a wave of these layers to six digits" +
                          (is_wave ? "; the nearest one found: " + wave_text(*rate) : std::string())});
}

bool starts_from_a_case(const std::string& type) { return type == "precursor" || type == "neighbour"; }

void check_starts_by_itself(const SoundMembers& members, const char* rule, std::vector<Mistake>& mistakes) {
  const auto type = members.get<std::string>("/physics/initial/type");
  if (type && starts_from_a_case(*type)) mistakes.push_back({"/physics/initial/type", *type, rule});
}

void check_interface_wave(const SoundMembers& members, const json& filled, std::vector<Mistake>& mistakes) {
  check_layer(members, filled, mistakes);
  if (!member_at(filled, "/physics/wave"))
    mistakes.push_back(
        {"/physics/wave", "missing", "flow \"interface_wave\" needs an object with decay and frequency"});
  check_starts_by_itself(members, "an interface wave starts by itself", mistakes);
  check_wave_rate(members, mistakes);
}

void check_no_wave(const json& filled, std::vector<Mistake>& mistakes) {
  if (member_at(filled, "/physics/wave"))
    mistakes.push_back({"/physics/wave", "given", "only flow \"interface_wave\" has one: leave it out"});
}

void check_rigid(const SoundMembers& members, const json& filled, std::vector<Mistake>& mistakes) {
  check_no_box(members, filled, mistakes);
  if (member_at(filled, "/physics/solid"))
    mistakes.push_back({"/physics/solid", "given", "flow \"rigid_channel\" has none: leave it out"});
  const auto ny_solid = members.get<int>("/physics/grid/ny_solid");
  if (ny_solid.value_or(0) != 0)
    mistakes.push_back(
        {"/physics/grid/ny_solid", std::to_string(*ny_solid), "must be 0 for flow \"rigid_channel\""});
}

/// The disc lies inside the box, a cell away from every wall, and B can come from it.
void check_disc(const SoundMembers& members, std::vector<Mistake>& mistakes) {
  const auto get = [&](const char* name) { return members.get<double>(std::string("/physics/") + name); };
  const auto x = get("solid/disc/x"), y = get("solid/disc/y"), radius = get("solid/disc/radius"),
             width = get("domain/length_x"), height = get("domain/height"), nx = get("grid/nx"),
             ny = get("grid/ny_fluid");
  if (x && y && radius && width && height && nx && ny) {
    const double side = *radius + *width / *nx, above = *radius + *height / *ny;
    if (*x < side || *x > *width - side || *y < above || *y > *height - above)
      mistakes.push_back({"/physics/solid/disc", "touches a wall", "must stay a cell away from every wall"});
  }
  if (members.get<std::string>("/physics/solid/extension") == "column")
    mistakes.push_back({"/physics/solid/extension", "column", "must be \"normal\" with a disc"});
  if (members.get<std::string>("/physics/solid/interface") == "height")
    mistakes.push_back({"/physics/solid/interface", "height", "must be \"mthinc\" or \"weno\" with a disc"});
  if (members.get<std::string>("/physics/solid/formulation") == "reference_map")
    mistakes.push_back({"/physics/solid/formulation", "reference_map",
                        "needs a layer: must be \"transported_B\" with a disc"});
}

void check_closed_box(const SoundMembers& members, const json& filled, std::vector<Mistake>& mistakes) {
  const auto flow = members.get<std::string>("/physics/flow");
  const bool has_disc = member_at(filled, "/physics/solid/disc");
  if (has_disc) check_disc(members, mistakes);
  if (!has_disc && (flow == "rotation" || member_at(filled, "/physics/solid")))
    mistakes.push_back({"/physics/solid/disc", "missing", "the solid of a closed box is a disc"});
  if (const auto ny = members.get<int>("/physics/grid/ny_solid"); ny.value_or(0) != 0)
    mistakes.push_back({"/physics/grid/ny_solid", std::to_string(*ny), "must be 0 in a closed box"});
  if (const auto nz = members.get<int>("/physics/grid/nz"); nz.value_or(1) != 1)
    mistakes.push_back({"/physics/grid/nz", std::to_string(*nz), "must be 1 in a closed box: it is flat"});
  if (const auto s = members.get<double>("/physics/grid/stretching"); s.value_or(0) != 0)
    mistakes.push_back({"/physics/grid/stretching", quoted(json(*s)), "must be 0 in a closed box"});
  const auto ratio = members.get<double>("/physics/solid/viscosity_ratio");
  if (ratio.value_or(1) != 1 && members.get<std::string>("/physics/time_step/viscosity") == "implicit")
    mistakes.push_back({"/physics/time_step/viscosity", "implicit", "needs viscosity_ratio 1"});
  check_starts_by_itself(members, "a closed box starts by itself", mistakes);
}

void check_no_accuracy(const SoundMembers& members, std::vector<Mistake>& mistakes) {
  if (members.get<double>("/physics/solid/dt_plus").value_or(0) != 0)
    mistakes.push_back(
        {"/physics/solid/dt_plus", "given", "limits the steps of flow \"elastic_wall\" only: leave it out"});
}

void check_initial(const SoundMembers& members, std::vector<Mistake>& mistakes) {
  const auto type = members.get<std::string>("/physics/initial/type");
  const auto precursor = members.get<std::string>("/physics/initial/precursor");
  if (!type || !precursor) return;
  if (starts_from_a_case(*type) && precursor->empty())
    mistakes.push_back(
        {"/physics/initial/precursor", "empty", "initial type \"" + *type + "\" needs that case's id"});
}

/// How far a case reaches from 0 to its far wall or its period, h.
std::optional<double> extent_of(const SoundMembers& members, const std::string& axis) {
  if (axis != "y") return members.get<double>("/physics/domain/length_" + axis);
  const auto height = members.get<double>("/physics/domain/height");
  const auto flow = members.get<std::string>("/physics/flow");
  if (!flow || (*flow != "elastic_wall" && *flow != "interface_wave")) return height;
  const auto layer = members.get<double>("/physics/domain/layer_height");
  return height && layer ? std::optional<double>(*height + *layer) : std::nullopt;
}

/// A position that is no number has been found by the schema, which names it but not its list.
void check_planes(const SoundMembers& members, std::vector<Mistake>& mistakes) {
  for (const std::string axis : {"x", "y", "z"}) {
    const std::string where = "/run/planes/" + axis;
    const auto extent = extent_of(members, axis);
    const json* positions = members.find(where);
    if (!extent || !positions) continue;
    for (std::size_t n = 0; n < positions->size(); ++n) {
      const json& position = positions->at(n);
      if (position.is_number() && position.get<double>() > *extent)
        mistakes.push_back({where + "/" + std::to_string(n), quoted(position),
                            "beyond the end of the box at " + axis + " = " + quoted(json(*extent)) + " h"});
    }
  }
}

}  // namespace

std::vector<Mistake> case_cross_checks(const json& filled, const std::vector<Mistake>& known) {
  const SoundMembers members(filled, known);
  std::vector<Mistake> mistakes;
  const auto flow = members.get<std::string>("/physics/flow");
  if (flow == "elastic_wall") check_layer(members, filled, mistakes);
  if (flow == "interface_wave") check_interface_wave(members, filled, mistakes);
  if (flow && flow != "interface_wave") check_no_wave(filled, mistakes);
  if (flow == "rigid_channel") check_rigid(members, filled, mistakes);
  if (flow == "cavity" || flow == "rotation") check_closed_box(members, filled, mistakes);
  if (flow && flow != "elastic_wall") check_no_accuracy(members, mistakes);
  check_initial(members, mistakes);
  check_planes(members, mistakes);
  return mistakes;
}

}  // namespace softwall
