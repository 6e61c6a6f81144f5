#include "solver/output/snapshot.hpp"

#include <array>
#include <cstdio>
#include <sstream>
#include <vector>

#include "solver/case/atomic_file.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/output/agree.hpp"
#include "solver/output/parallel_file.hpp"
#include "solver/output/watchdog.hpp"

namespace softwall::output {

namespace {

std::filesystem::path snapshot_file(const RunFiles& run, std::int64_t step, const char* extension) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "fields-%09lld%s", static_cast<long long>(step), extension);
  return run.fields() / name.data();
}

/// Mean of each face and its neighbour at (i + di, j + dj, k + dk), at the center between them.
grid::Field to_centers(const grid::Field& face, const grid::Grid& g, std::array<int, 3> d) {
  grid::Field center(g, 0);
  const auto q = face.view();
  const auto c = center.view();
  grid::for_each_cell(grid::all_cells(g), [=](int i, int j, int k) {
    c(i, j, k) = (q(i, j, k) + q(i + d[0], j + d[1], k + d[2])) / 2;
  });
  return center;
}

std::vector<double> faces_in_y(const grid::Grid& g) {
  std::vector<double> y;
  for (int j = 0; j <= g.ny; ++j) y.push_back(g.y_face[j]);
  return y;
}

std::vector<double> uniform_faces(int n, double spacing) {
  std::vector<double> x;
  for (int i = 0; i <= n; ++i) x.push_back(i * spacing);
  return x;
}

std::string xdmf(const std::string& data, const time::State& state, const grid::Grid& g,
                 const std::vector<std::string>& fields) {
  std::ostringstream out;
  out.precision(17);
  const auto item = [&](const std::string& name, const std::string& extents, std::size_t bytes) {
    out << "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"" << bytes << "\" Dimensions=\""
        << extents << "\">" << data << ":/" << name << "</DataItem>";
  };
  std::ostringstream cells;
  cells << g.nz_global << " " << g.ny << " " << g.nx_global;
  out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain><Grid Name=\"channel\" "
         "GridType=\"Uniform\">\n"
      << "<Time Value=\"" << state.time << "\"/>\n<Topology TopologyType=\"3DRectMesh\" Dimensions=\""
      << g.nz_global + 1 << " " << g.ny + 1 << " " << g.nx_global + 1
      << "\"/>\n<Geometry GeometryType=\"VXVYVZ\">";
  item("x", std::to_string(g.nx_global + 1), sizeof(double));
  item("y", std::to_string(g.ny + 1), sizeof(double));
  item("z", std::to_string(g.nz_global + 1), sizeof(double));
  out << "</Geometry>\n";
  for (const auto& name : fields) {
    out << "<Attribute Name=\"" << name << "\" AttributeType=\"Scalar\" Center=\"Cell\">";
    item(name, cells.str(), sizeof(grid::Real));
    out << "</Attribute>\n";
  }
  out << "</Grid></Domain></Xdmf>\n";
  return out.str();
}

}  // namespace

void write_snapshot(const RunFiles& run, const time::State& state, const time::Setup& setup) {
  const auto& all = setup.decomposition.all();
  const auto& g = setup.grid;
  const auto file = snapshot_file(run, state.step, ".h5");
  auto temporary = file;
  temporary += ".tmp";
  const Watchdog watchdog(Watchdog::seconds_for(static_cast<std::int64_t>(g.cells()) * 40));
  agree_on_root(all, ExitCode::kIoFailure, [&] { std::filesystem::create_directories(run.fields()); });
  ParallelFile out(temporary, all, 0);
  out.write_number({"time", "simulated time, h / U_b"}, state.time);
  out.write_values({"x", "cell faces, h"}, uniform_faces(g.nx_global, g.dx));
  out.write_values({"y", "cell faces, h"}, faces_in_y(g));
  out.write_values({"z", "cell faces, h"}, uniform_faces(g.nz_global, g.dz));
  std::vector<std::string> names{"u", "v", "w", "p"};
  out.write_field({"u", "streamwise velocity, U_b"}, to_centers(state.velocity.x, g, {1, 0, 0}), g.ny, g);
  out.write_field({"v", "wall-normal velocity, U_b"}, to_centers(state.velocity.y, g, {0, 1, 0}), g.ny, g);
  out.write_field({"w", "spanwise velocity, U_b"}, to_centers(state.velocity.z, g, {0, 0, 1}), g.ny, g);
  out.write_field({"p", "pressure, rho U_b^2"}, state.pressure, g.ny, g);
  if (state.elastic) {
    out.write_field({"phi", "solid fraction"}, state.material.phi, g.ny, g);
    names.emplace_back("phi");
  }
  out.close();
  agree_on_root(all, ExitCode::kIoFailure, [&] {
    publish_file(temporary, file);
    write_atomically(snapshot_file(run, state.step, ".xdmf"),
                     xdmf(file.filename().string(), state, g, names));
  });
}

}  // namespace softwall::output
