#include "solver/output/film_in_xdmf.hpp"

#include <array>
#include <sstream>
#include <vector>

#include "solver/output/xdmf.hpp"
#include "solver/run_directory/hdf5_image.hpp"

namespace softwall::output {
namespace {

using analysis::Hdf5Id;

constexpr const char* kAxes = "xyz";

/// Name of the cell centres along an axis.
std::string center_of(std::size_t axis) { return std::string("grid/") + kAxes[axis] + "_center"; }

/// A group with numbers in a plane across one axis.
struct Group {
  std::string name;
  std::size_t axis = 1;
  std::vector<std::string> quantities;
};

/// Groups of planes are named by their axis, "x_0"; the interface lies across y.
std::vector<Group> groups_of(hid_t file) {
  std::vector<Group> groups;
  for (const std::string& name : analysis::member_names(file)) {
    const std::size_t axis = name == "interface" ? 1 : std::string(kAxes).find(name.front());
    if (name != "interface" && (axis == std::string::npos || name.find('_') != 1)) continue;
    const Hdf5Id group = analysis::open_group(file, name);
    groups.push_back({name, axis, analysis::member_names(group.get())});
    std::erase(groups.back().quantities, "position");
  }
  return groups;
}

/// Points along z, y and x: 1 across the plane.
std::string extents_of(const std::array<hsize_t, 3>& points, std::size_t across) {
  std::string text;
  for (const std::size_t axis : {2U, 1U, 0U})
    text += (text.empty() ? "" : " ") + std::to_string(axis == across ? 1 : points[axis]);
  return text;
}

std::string plane_in_xdmf(const Group& one, const XdmfSource& source, const std::array<hsize_t, 3>& points) {
  const std::string extents = extents_of(points, one.axis);
  std::string text = "<Grid Name=\"" + one.name +
                     "\" GridType=\"Uniform\">\n<Topology TopologyType=\"3DRectMesh\" Dimensions=\"" +
                     extents + "\"/>\n<Geometry GeometryType=\"VXVYVZ\">";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool across = axis == one.axis;
    text += source.item(across ? one.name + "/position" : center_of(axis),
                        std::to_string(across ? 1 : points[axis]), sizeof(double));
  }
  text += "</Geometry>\n";
  for (const std::string& name : one.quantities) {
    const std::string data = source.item(one.name + "/" + name, extents, sizeof(float));
    text += XdmfSource::attribute(name, "Scalar", "Node", data);
  }
  return text + "</Grid>\n";
}

double time_of(hid_t file) {
  const Hdf5Id time = analysis::open_dataset(file, "moment/time");
  return analysis::read_dataset(time.get(), "moment/time", {1}).front();
}

}  // namespace

std::string film_in_xdmf(const std::filesystem::path& path) {
  const Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "it is not an HDF5 file");
  std::array<hsize_t, 3> points{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name = center_of(axis);
    points[axis] = analysis::dataset_length(analysis::open_dataset(file.get(), name).get(), name);
  }
  std::ostringstream out;
  out.precision(17);
  out << "<Grid Name=\"moment\" GridType=\"Collection\" CollectionType=\"Spatial\"><Time Value=\""
      << time_of(file.get()) << "\"/>\n";
  const XdmfSource source{path.filename().string()};
  for (const Group& one : groups_of(file.get())) out << plane_in_xdmf(one, source, points);
  out << "</Grid>\n";
  return out.str();
}

}  // namespace softwall::output
