#include "solver/output/checkpoint_reader.hpp"

#include <algorithm>
#include <sstream>

#include "solver/output/agree.hpp"

namespace softwall::output {

namespace {

using analysis::Hdf5Id;
using analysis::must;

Hdf5Id space_of(const Hdf5Id& dataset, const std::string& name) {
  return {H5Dget_space(dataset.get()), H5Sclose, name + " has no shape"};
}

template <class T>
void must_equal(const char* what, const T& in_file, const T& expected) {
  if (in_file == expected) return;
  std::ostringstream text;
  text.precision(17);
  text << "its " << what << " is " << in_file << ", this case has " << expected;
  throw std::runtime_error(text.str());
}

std::string cells(const std::array<int, 3>& n) {
  return std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
}

void check_grid(const CheckpointFile& file, const CheckpointHeader& header, const grid::Grid& g) {
  must_equal("precision", header.precision, name_of(grid::kPrecision));
  must_equal("grid (nx x ny x nz)", cells(header.grid), cells({g.nx_global, g.ny, g.nz_global}));
  must_equal("length in x", header.length[0], g.length_x);
  must_equal("height", header.length[1], g.height);
  must_equal("length in z", header.length[2], g.length_z);
  const auto faces = file.values("grid/y_face");
  must_equal("number of faces in y", static_cast<int>(faces.size()), g.ny + 1);
  for (int j = 0; j <= g.ny; ++j) {
    must_equal("height of a cell face", faces[static_cast<std::size_t>(j)], g.y_face[j]);
  }
}

void read_field(const CheckpointFile& file, const time::NamedField& f, const grid::Grid& g) {
  const std::string name = "fields/" + f.name;
  must_equal(("extent of " + name + " (nz x rows x nx)").c_str(), cells(file.extents(name)),
             cells({g.nz_global, f.rows, g.nx_global}));
  const auto values = file.columns(name, {g.x_begin, g.nx, g.z_begin, g.nz});
  const auto q = f.field->view();
  auto from = values.begin();
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < f.rows; ++j, from += g.nx) std::copy(from, from + g.nx, &q(0, j, k));
  }
}

}  // namespace

CheckpointFile::CheckpointFile(const std::filesystem::path& path)
    : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "it is not an HDF5 file") {}

double CheckpointFile::number(const std::string& name) const {
  const auto all = values(name);
  if (all.size() != 1) throw std::runtime_error(name + " is not one number");
  return all.front();
}

std::int64_t CheckpointFile::integer(const std::string& name) const {
  const Hdf5Id dataset = analysis::open_dataset(file_.get(), name);
  std::int64_t value = 0;
  if (analysis::dataset_length(dataset.get(), name) != 1)
    throw std::runtime_error(name + " is not one number");
  must(H5Dread(dataset.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value),
       "cannot read " + name);
  return value;
}

std::vector<double> CheckpointFile::values(const std::string& name) const {
  const Hdf5Id dataset = analysis::open_dataset(file_.get(), name);
  return analysis::read_dataset(dataset.get(), name, {analysis::dataset_length(dataset.get(), name)});
}

bool CheckpointFile::has(const std::string& group, const std::string& name) const {
  const Hdf5Id opened = analysis::open_group(file_.get(), group);
  return std::ranges::count(analysis::member_names(opened.get()), name) > 0;
}

std::map<std::string, std::vector<double>> CheckpointFile::more_statistics() const {
  std::map<std::string, std::vector<double>> found;
  const Hdf5Id group = analysis::open_group(file_.get(), "statistics");
  for (const std::string& name : analysis::member_names(group.get()))
    if (name != "accumulators") found[name] = values("statistics/" + name);
  return found;
}

std::array<int, 3> CheckpointFile::extents(const std::string& field) const {
  const Hdf5Id dataset = analysis::open_dataset(file_.get(), field);
  const Hdf5Id space = space_of(dataset, field);
  std::array<hsize_t, 3> shape{};
  if (H5Sget_simple_extent_ndims(space.get()) != 3)
    throw std::runtime_error(field + " has not three dimensions");
  must(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr), field + " has no shape");
  return {static_cast<int>(shape[0]), static_cast<int>(shape[1]), static_cast<int>(shape[2])};
}

std::vector<double> CheckpointFile::columns(const std::string& field, const Columns& which) const {
  const auto size = [](int n) { return static_cast<hsize_t>(n); };
  const hsize_t rows = size(extents(field)[1]);
  const std::array<hsize_t, 3> start{size(which.z_begin), 0, size(which.x_begin)},
      count{size(which.nz), rows, size(which.nx)};
  const Hdf5Id dataset = analysis::open_dataset(file_.get(), field), space = space_of(dataset, field);
  const Hdf5Id memory(H5Screate_simple(3, count.data(), nullptr), H5Sclose, "cannot create a dataspace");
  must(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
       field + " does not hold these columns");
  std::vector<double> values(count[0] * count[1] * count[2]);
  must(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT, values.data()),
       "cannot read " + field);
  return values;
}

CheckpointContents load_checkpoint(const std::filesystem::path& path, const CheckpointHeader& header,
                                   const time::Setup& setup, time::State& state) {
  CheckpointContents record;
  agree(setup.decomposition.all(), ExitCode::kCheckpointRefused, [&] {
    try {
      const CheckpointFile file(path);
      check_grid(file, header, setup.grid);
      for (const time::NamedField& f : time::fields_of(state)) read_field(file, f, setup.grid);
      state.time = file.number("time");
      state.step = file.integer("step");
      state.driving_gradient = file.number("driving_gradient");
      must_equal("step (header and contents differ)", header.step, state.step);
      must_equal("time (header and contents differ)", header.time, state.time);
      record.statistics = file.values("statistics/accumulators");
      record.spectra = file.more_statistics();
      const bool counts_steps = file.has("diagnostics", "limited_since_step");
      record.limited_cells = counts_steps ? file.number("diagnostics/limited_cells") : 0.0;
      record.limited_since_step =
          counts_steps ? file.number("diagnostics/limited_since_step") : double(state.step);
      record.solid_volume_at_start = file.number("diagnostics/solid_volume_at_start");
    } catch (const std::exception& error) {
      throw std::runtime_error(path.filename().string() + ": " + error.what());
    }
  });
  return record;
}

}  // namespace softwall::output
