#include "solver/output/joined_fields.hpp"

#include "solver/run_directory/hdf5_image.hpp"

namespace softwall::output {
namespace {

using analysis::Hdf5Id;
using analysis::must;

Hdf5Id space_of_shape(const std::vector<hsize_t>& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose,
          "cannot create a dataspace"};
}

std::vector<hsize_t> shape_of(const Hdf5Id& dataset) {
  const Hdf5Id space(H5Dget_space(dataset.get()), H5Sclose, "a dataset has no shape");
  std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.get())));
  must(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr), "cannot read a shape");
  return shape;
}

void join(hid_t file, const JoinedField& field) {
  const Hdf5Id first = analysis::open_dataset(file, field.components.front());
  const Hdf5Id type(H5Dget_type(first.get()), H5Tclose, "a dataset has no type");
  const std::vector<hsize_t> own = shape_of(first);
  std::vector<hsize_t> shape = own, start(own.size() + 1, 0), count = own;
  shape.push_back(field.components.size());
  count.push_back(1);
  const Hdf5Id all = space_of_shape(shape), part = space_of_shape(own);
  const Hdf5Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "cannot create a property list");
  must(H5Pset_obj_track_times(creation.get(), false), "cannot leave out the time stamps");
  for (const std::string& component : field.components) {
    must(H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
         "cannot select a component");
    must(H5Pset_virtual(creation.get(), all.get(), ".", component.c_str(), part.get()),
         "cannot join " + component);
    ++start.back();
  }
  const Hdf5Id joined(
      H5Dcreate2(file, field.name.c_str(), type.get(), all.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
      H5Dclose, "cannot create " + field.name);
  analysis::write_attribute(joined.get(), "description", field.description);
}

}  // namespace

void join_fields(const std::filesystem::path& file, const std::vector<JoinedField>& fields) {
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot create a property list");
  must(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110), "cannot choose the format");
  const Hdf5Id opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, access.get()), H5Fclose, "cannot open");
  for (const JoinedField& field : fields) join(opened.get(), field);
  must(H5Fflush(opened.get(), H5F_SCOPE_GLOBAL), "cannot write " + file.string());
}

}  // namespace softwall::output
