#include "solver/output/remembered_layout.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/case/atomic_file.hpp"
#include "solver/case/input_file.hpp"
#include "solver/output/agree.hpp"
#include "solver/time/fastest_layout.hpp"

namespace softwall::output {

namespace {

using nlohmann::json;
using parallel::Layout;

/// {"format": 1, "layouts": {"64": {"px": 4, "pz": 16}, ...}}; an empty one for anything else.
json read_layouts(const RunFiles& run) {
  json layouts = json::object();
  if (!std::filesystem::exists(run.layout())) return layouts;
  try {
    json file = json::parse(read_input_file(run.layout()));
    if (file.at("format") == 1 && file.at("layouts").is_object()) layouts = file.at("layouts");
  } catch (const std::exception&) {
    layouts = json::object();  // measured anew
  }
  return layouts;
}

std::optional<Layout> find(const json& layouts, int ranks, const std::vector<Layout>& possible) {
  try {
    const json& entry = layouts.at(std::to_string(ranks));
    const Layout layout{entry.at("px").get<int>(), entry.at("pz").get<int>()};
    if (std::find(possible.begin(), possible.end(), layout) != possible.end()) return layout;
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return std::nullopt;
}

void remember(const RunFiles& run, json layouts, int ranks, const Layout& layout) {
  layouts[std::to_string(ranks)] = {{"px", layout.px}, {"pz", layout.pz}};
  write_atomically(run.layout(), json{{"format", 1}, {"layouts", layouts}}.dump() + "\n");
}

}  // namespace

std::optional<Layout> remembered_layout(const RunFiles& run, const Physics& physics,
                                        const parallel::Communicator& world, int few) {
  const auto possible = parallel::possible_layouts(world.size(), physics.grid.nx, physics.grid.nz);
  if (world.size() <= few || possible.size() < 2) return std::nullopt;
  std::string text;
  agree_on_root(world, ExitCode::kIoFailure, [&] { text = read_layouts(run).dump(); });
  const json layouts = json::parse(from_root(world, text));
  if (const auto found = find(layouts, world.size(), possible)) return found;
  const Layout layout = time::fastest_layout(physics, world);
  agree_on_root(world, ExitCode::kIoFailure, [&] { remember(run, layouts, world.size(), layout); });
  return layout;
}

}  // namespace softwall::output
