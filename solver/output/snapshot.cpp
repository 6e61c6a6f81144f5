#include "solver/output/snapshot.hpp"

#include <string>
#include <vector>

#include "solver/case/atomic_file.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/output/agree.hpp"
#include "solver/output/centers.hpp"
#include "solver/output/joined_fields.hpp"
#include "solver/output/parallel_file.hpp"
#include "solver/output/snapshot_in_xdmf.hpp"
#include "solver/output/watchdog.hpp"

namespace softwall::output {

namespace {

/// Mean of a quantity on faces or edges, whose ghost cells are filled, over those of each cell.
grid::Field to_centers(const grid::Field& q, const Place& place, const grid::Grid& g) {
  grid::Field center(g, 0);
  const auto from = q.view();
  const auto to = center.view();
  grid::for_each_cell(grid::all_cells(g),
                      [=](int i, int j, int k) { to(i, j, k) = at_center(from, place, i, j, k); });
  return center;
}

/// The same of a field of the solid, whose ghost cells are filled near it alone.
grid::Field solid_to_centers(const grid::Field& field, const Place& place, time::Setup& setup) {
  const auto& g = setup.grid;
  grid::Field copy(g, 1);
  const auto from = field.view();
  const auto to = copy.view();
  grid::for_each_cell({0, g.nx, 0, g.ny + place[1], 0, g.nz},
                      [=](int i, int j, int k) { to(i, j, k) = from(i, j, k); });
  setup.halo.fill({&copy});
  return to_centers(copy, place, g);
}

/// A field of the snapshot, and where it comes from.
struct Source {
  Label label;
  const grid::Field* field;
  Place place{0, 0, 0};
  bool of_solid = false;
};

std::vector<Source> sources_of(const time::State& s) {
  std::vector<Source> all = {{{"u", "streamwise velocity, U_b"}, &s.velocity.x, {1, 0, 0}},
                             {{"v", "wall-normal velocity, U_b"}, &s.velocity.y, {0, 1, 0}},
                             {{"w", "spanwise velocity, U_b"}, &s.velocity.z, {0, 0, 1}},
                             {{"p", "pressure, rho U_b^2"}, &s.pressure}};
  if (!s.elastic) return all;
  const auto& m = s.material;
  all.push_back({{"phi", "solid fraction"}, &m.phi});
  const std::string displacement = "displacement of the material that is here, h; of the solid alone";
  const std::string tensor = "left Cauchy-Green tensor; of the solid alone";
  const auto add = [&](const char* name, const std::string& what, const grid::Field& field,
                       const Place& place) {
    all.push_back({{name, what}, &field, place, true});
  };
  if (m.formulation == SolidFormulation::kReferenceMap) {
    add("d_x", displacement, m.displacement.x, {1, 0, 0});
    add("d_y", displacement, m.displacement.y, {0, 1, 0});
    add("d_z", displacement, m.displacement.z, {0, 0, 1});
    return all;
  }
  add("B_xx", tensor, m.B.xx, {0, 0, 0});
  add("B_xy", tensor, m.B.xy, {1, 1, 0});
  add("B_xz", tensor, m.B.xz, {1, 0, 1});
  add("B_yy", tensor, m.B.yy, {0, 0, 0});
  add("B_yz", tensor, m.B.yz, {0, 1, 1});
  add("B_zz", tensor, m.B.zz, {0, 0, 0});
  return all;
}

std::vector<JoinedField> joined_of(const time::State& s) {
  std::vector<JoinedField> all = {{"velocity", "u, v, w", {"u", "v", "w"}}};
  if (!s.elastic) return all;
  if (s.material.formulation == SolidFormulation::kReferenceMap)
    all.push_back({"displacement", "d_x, d_y, d_z", {"d_x", "d_y", "d_z"}});
  else
    all.push_back(
        {"B", "B_xx, B_xy, B_xz, B_yy, B_yz, B_zz", {"B_xx", "B_xy", "B_xz", "B_yy", "B_yz", "B_zz"}});
  return all;
}

}  // namespace

void write_snapshot(const RunFiles& run, const time::State& state, time::Setup& setup,
                    Collection& collection) {
  const auto& all = setup.decomposition.all();
  const auto& g = setup.grid;
  const auto file = run.fields_of(state.step);
  auto temporary = file;
  temporary += ".tmp";
  const auto sources = sources_of(state);
  const Watchdog watchdog(Watchdog::seconds_for(static_cast<std::int64_t>(g.cells()) * 8 *
                                                static_cast<std::int64_t>(sources.size())));
  agree_on_root(all, ExitCode::kIoFailure, [&] { std::filesystem::create_directories(run.fields()); });
  ParallelFile out(temporary, all, 0);
  out.write_number({"time", "simulated time, h / U_b"}, state.time);
  const CellFaces faces = faces_of(g);
  out.write_values({"x", "cell faces, h"}, faces.x);
  out.write_values({"y", "cell faces, h"}, faces.y);
  out.write_values({"z", "cell faces, h"}, faces.z);
  for (const auto& [label, field, place, of_solid] : sources) {
    if (place == Place{0, 0, 0})
      out.write_field(label, *field, g.ny, g);
    else
      out.write_field(label, of_solid ? solid_to_centers(*field, place, setup) : to_centers(*field, place, g),
                      g.ny, g);
  }
  out.close();
  agree_on_root(all, ExitCode::kIoFailure, [&] {
    join_fields(temporary, joined_of(state));
    publish_file(temporary, file);
    collection.add(file);
  });
}

Collection collection_of_snapshots(const RunFiles& run) {
  return {run.fields() / "fields.xdmf", snapshot_in_xdmf};
}

}  // namespace softwall::output
