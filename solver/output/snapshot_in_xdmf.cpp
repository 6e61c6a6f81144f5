#include "solver/output/snapshot_in_xdmf.hpp"

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "solver/output/xdmf.hpp"
#include "solver/run_directory/hdf5_image.hpp"

namespace softwall::output {
namespace {

using analysis::Hdf5Id;

/// How ParaView is to take a dataset at cell centres.
struct Attribute {
  const char* name;
  const char* kind;
  int components;
};

/// Components of a vector stand alone only in files of earlier versions.
constexpr std::array<Attribute, 3> kScalarVelocity = {
    {{"u", "Scalar", 1}, {"v", "Scalar", 1}, {"w", "Scalar", 1}}};
constexpr std::array<Attribute, 5> kAttributes = {{{"velocity", "Vector", 3},
                                                   {"p", "Scalar", 1},
                                                   {"phi", "Scalar", 1},
                                                   {"displacement", "Vector", 3},
                                                   {"B", "Tensor6", 6}}};

struct Snapshot {
  XdmfSource source;
  double time = 0;
  std::array<hsize_t, 3> faces{};  ///< numbers of x, y and z
  std::size_t bytes = 0;           ///< of one number of a field
  std::vector<Attribute> attributes;
};

bool has(const Hdf5Id& file, const char* name) { return H5Lexists(file.get(), name, H5P_DEFAULT) > 0; }

Snapshot read_snapshot(const std::filesystem::path& path) {
  const Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "it is not an HDF5 file");
  Snapshot found;
  found.source = {path.filename().string()};
  found.time = analysis::read_dataset(analysis::open_dataset(file.get(), "time").get(), "time", {1}).front();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    found.faces[i] = analysis::dataset_length(analysis::open_dataset(file.get(), axis).get(), axis);
  }
  const Hdf5Id pressure = analysis::open_dataset(file.get(), "p");
  const Hdf5Id type(H5Dget_type(pressure.get()), H5Tclose, "p has no type");
  found.bytes = H5Tget_size(type.get());
  if (!has(file, "velocity")) found.attributes.assign(kScalarVelocity.begin(), kScalarVelocity.end());
  for (const Attribute& attribute : kAttributes)
    if (has(file, attribute.name)) found.attributes.push_back(attribute);
  return found;
}

std::string extents(const Snapshot& one, hsize_t less) {
  const auto& [x, y, z] = one.faces;
  return std::to_string(z - less) + " " + std::to_string(y - less) + " " + std::to_string(x - less);
}

std::string grid_of(const Snapshot& one) {
  std::ostringstream out;
  out.precision(17);
  out << "<Grid Name=\"channel\" GridType=\"Uniform\"><Time Value=\"" << one.time
      << "\"/>\n<Topology TopologyType=\"3DRectMesh\" Dimensions=\"" << extents(one, 0)
      << "\"/>\n<Geometry GeometryType=\"VXVYVZ\">";
  for (std::size_t i = 0; i < 3; ++i)
    out << one.source.item(std::string(1, "xyz"[i]), std::to_string(one.faces[i]), sizeof(double));
  out << "</Geometry>\n";
  for (const auto& [name, kind, components] : one.attributes) {
    const std::string more = components > 1 ? " " + std::to_string(components) : "";
    out << XdmfSource::attribute(name, kind, "Cell",
                                 one.source.item(name, extents(one, 1) + more, one.bytes));
  }
  out << "</Grid>\n";
  return out.str();
}

}  // namespace

std::string snapshot_in_xdmf(const std::filesystem::path& file) { return grid_of(read_snapshot(file)); }

}  // namespace softwall::output
