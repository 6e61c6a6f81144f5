#include "solver/output/film.hpp"

#include <array>
#include <utility>

#include "solver/output/agree.hpp"
#include "solver/output/centers.hpp"
#include "solver/output/film_in_xdmf.hpp"
#include "solver/output/watchdog.hpp"

namespace softwall::output {
namespace {

using analysis::NamedArray;

NamedArray array_of(std::string group, std::string name, const std::array<int, 2>& shape,
                    const std::vector<float>& values) {
  NamedArray array{std::move(group), std::move(name), "", "", {}, {values.begin(), values.end()}};
  for (const int n : shape) array.shape.push_back(static_cast<std::size_t>(n));
  return array;
}

/// Numbers of the whole grid or moment, in all their digits.
NamedArray exact_array(std::string group, std::string name, std::vector<double> values) {
  const std::size_t n = values.size();
  return {std::move(group), std::move(name), "", "", {n}, std::move(values), true};
}

NamedArray described(NamedArray array, std::string unit, std::string description) {
  array.unit = std::move(unit);
  array.description = std::move(description);
  return array;
}

std::vector<double> centers_between(const std::vector<double>& faces) {
  std::vector<double> centers;
  for (std::size_t n = 1; n < faces.size(); ++n) centers.push_back((faces[n - 1] + faces[n]) / 2);
  return centers;
}

std::vector<NamedArray> moment_and_grid(const time::State& s, const grid::Grid& g) {
  const CellFaces faces = faces_of(g);
  std::vector<NamedArray> all;
  all.push_back(described(exact_array("moment", "time", {s.time}), "h/U_b", "simulated time"));
  all.push_back(
      described(exact_array("moment", "step", {static_cast<double>(s.step)}), "1", "steps since time 0"));
  for (const auto& [axis, of_axis] :
       {std::pair("x", &faces.x), std::pair("y", &faces.y), std::pair("z", &faces.z)}) {
    const std::string name = axis;
    all.push_back(described(exact_array("grid", name + "_face", *of_axis), "h", "faces of the cells"));
    all.push_back(described(exact_array("grid", name + "_center", centers_between(*of_axis)), "h",
                            "centres of the cells"));
  }
  return all;
}

}  // namespace

Film::Film(RunFiles run, const Case& definition, const time::Setup& setup)
    : run_(std::move(run)),
      case_id_(definition.id),
      setup_(setup),
      has_layer_(setup.solid && !is_closed_box(setup.physics.flow)),
      collection_(run_.planes() / "planes.xdmf", film_in_xdmf) {
  const PlaneSpec& asked = definition.run.planes;
  int axis = 0;
  for (const auto* positions : {&asked.x, &asked.y, &asked.z}) {
    for (std::size_t n = 0; n < positions->size(); ++n) {
      const std::string name = std::string(1, "xyz"[axis]) + "_" + std::to_string(n);
      planes_.push_back({name, nearest_plane(axis, (*positions)[n], setup.grid)});
    }
    ++axis;
  }
}

void Film::add_plane(const Named& one, const time::State& s, std::vector<NamedArray>& arrays) const {
  const grid::Grid& g = setup_.grid;
  const auto add = [&](const char* name, const grid::Field& field, const Place& place, const char* unit,
                       const char* description) {
    const auto q = field.view();
    const auto values = gather_plane(one.plane, g, setup_.decomposition.all(), [&](int i, int j, int k) {
      return static_cast<float>(at_center(q, place, i, j, k));
    });
    arrays.push_back(described(array_of(one.name, name, one.plane.shape(g), values), unit, description));
  };
  arrays.push_back(described(exact_array(one.name, "position", {one.plane.position}), "h",
                             "of the cell centres along the axis that the plane lies across"));
  add("u", s.velocity.x, {1, 0, 0}, "U_b", "streamwise velocity");
  add("v", s.velocity.y, {0, 1, 0}, "U_b", "wall-normal velocity");
  add("w", s.velocity.z, {0, 0, 1}, "U_b", "spanwise velocity");
  add("p", s.pressure, {0, 0, 0}, "rho U_b^2", "pressure");
  if (s.elastic) add("phi", s.material.phi, {0, 0, 0}, "1", "solid fraction");
}

void Film::add_interface(const std::vector<double>& heights, std::vector<NamedArray>& arrays) const {
  const grid::Grid& g = setup_.grid;
  const CellPlane columns{1, 0, g.y_face[g.ny_fluid]};
  const auto values = gather_plane({1, 0, 0}, g, setup_.decomposition.all(), [&](int i, int, int k) {
    return static_cast<float>(heights[static_cast<std::size_t>(i + g.nx * k)]);
  });
  arrays.push_back(described(exact_array("interface", "position", {columns.position}), "h",
                             "height of the interface at rest"));
  arrays.push_back(described(array_of("interface", "height", columns.shape(g), values), "h",
                             "of the interface over each column, as the statistics take it"));
}

void Film::write(const time::State& state, const std::vector<double>& heights) {
  const auto& all = setup_.decomposition.all();
  std::vector<NamedArray> arrays = moment_and_grid(state, setup_.grid);
  for (const Named& one : planes_) add_plane(one, state, arrays);
  if (has_layer_) add_interface(heights, arrays);
  std::int64_t bytes = 0;
  for (const NamedArray& array : arrays) bytes += static_cast<std::int64_t>(array.values.size() * 8);
  const Watchdog watchdog(Watchdog::seconds_for(bytes));
  agree_on_root(all, ExitCode::kIoFailure, [&] {
    std::filesystem::create_directories(run_.planes());
    const auto file = run_.planes_of(state.step);
    analysis::write_arrays(file, case_id_, arrays);
    collection_.add(file);
  });
}

}  // namespace softwall::output
