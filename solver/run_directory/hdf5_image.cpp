#include "solver/run_directory/hdf5_image.hpp"

#include <array>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace softwall::analysis {
namespace {

constexpr std::size_t kGrowthBytes = 1 << 20;  // by which an image in memory grows

/// The innermost entry of HDF5's error stack: nearest to the cause.
std::string hdf5_reason() {
  std::string reason;
  const auto keep = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
    *static_cast<std::string*>(out) = error->desc == nullptr ? "" : error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, +keep, &reason);
  return reason.empty() ? "no reason given" : reason;
}

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + " (HDF5: " + hdf5_reason() + ")");
}

Hdf5Id memory_access() {
  Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot create an HDF5 property list");
  must(H5Pset_fapl_core(access.get(), kGrowthBytes, 0), "cannot choose HDF5's memory driver");
  return access;
}

/// Properties of a new file, group or dataset: without its time of birth, so that equal contents make equal
/// files.
Hdf5Id timeless(hid_t kind) {
  Hdf5Id properties(H5Pcreate(kind), H5Pclose, "cannot create an HDF5 property list");
  must(H5Pset_obj_track_times(properties.get(), false), "cannot switch off HDF5's time stamps");
  return properties;
}

Hdf5Id dataspace(const std::vector<hsize_t>& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose,
          "cannot create an HDF5 dataspace"};
}

Hdf5Id text_type(std::size_t size) {
  Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose, "cannot create an HDF5 text type");
  must(H5Tset_size(type.get(), size), "cannot size an HDF5 text type");
  must(H5Tset_cset(type.get(), H5T_CSET_UTF8), "cannot set the character set of an HDF5 text type");
  return type;
}

Hdf5Id open_attribute(hid_t object, const std::string& name, H5T_class_t expected) {
  Hdf5Id attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "has no attribute " + name);
  const Hdf5Id type(H5Aget_type(attribute.get()), H5Tclose, "attribute " + name + " has no type");
  const Hdf5Id space(H5Aget_space(attribute.get()), H5Sclose, "attribute " + name + " has no shape");
  if (H5Tget_class(type.get()) != expected || H5Sget_simple_extent_npoints(space.get()) != 1) {
    throw std::runtime_error("attribute " + name + " is of the wrong kind");
  }
  return attribute;
}

}  // namespace

void must(herr_t status, const std::string& what) {
  if (status < 0) fail(what);
}

Hdf5Id::Hdf5Id(hid_t id, Close close, const std::string& what) : id_(id), close_(close) {
  if (id < 0) fail(what);
}

Hdf5Id::~Hdf5Id() {
  if (id_ >= 0) close_(id_);
}

QuietHdf5::QuietHdf5() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietHdf5::~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

Hdf5Id create_image() {
  const Hdf5Id access = memory_access();
  return {H5Fcreate("statistics in memory", H5F_ACC_TRUNC, timeless(H5P_FILE_CREATE).get(), access.get()),
          H5Fclose, "cannot create an HDF5 file in memory"};
}

Hdf5Id open_image(std::string_view bytes) {
  const Hdf5Id access = memory_access();
  std::string copy(bytes);  // HDF5 wants a writable pointer and makes its own copy
  must(H5Pset_file_image(access.get(), copy.data(), copy.size()), "cannot hand the file to HDF5");
  return {H5Fopen("statistics in memory", H5F_ACC_RDONLY, access.get()), H5Fclose, "is not an HDF5 file"};
}

std::string image_bytes(const Hdf5Id& file) {
  must(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), "cannot flush an HDF5 file in memory");
  const ssize_t size = H5Fget_file_image(file.get(), nullptr, 0);
  if (size <= 0) fail("cannot take an HDF5 file out of memory");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file.get(), bytes.data(), bytes.size()) != size) {
    fail("cannot take an HDF5 file out of memory");
  }
  return bytes;
}

Hdf5Id create_group(hid_t parent, const std::string& name) {
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, timeless(H5P_GROUP_CREATE).get(), H5P_DEFAULT),
          H5Gclose, "cannot create group " + name};
}

Hdf5Id open_group(hid_t parent, const std::string& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "has no group " + name};
}

std::vector<std::string> member_names(hid_t group) {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  must(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, +collect, &names), "cannot list a group");
  return names;
}

void write_attribute(hid_t object, const std::string& name, double value) {
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose, "cannot create an HDF5 dataspace");
  const Hdf5Id attribute(
      H5Acreate2(object, name.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      "cannot create attribute " + name);
  must(H5Awrite(attribute.get(), H5T_NATIVE_DOUBLE, &value), "cannot write attribute " + name);
}

void write_attribute(hid_t object, const std::string& name, const std::string& value) {
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose, "cannot create an HDF5 dataspace");
  const Hdf5Id type = text_type(value.size() + 1);
  const Hdf5Id attribute(H5Acreate2(object, name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "cannot create attribute " + name);
  must(H5Awrite(attribute.get(), type.get(), value.c_str()), "cannot write attribute " + name);
}

double read_number_attribute(hid_t object, const std::string& name) {
  const Hdf5Id attribute = open_attribute(object, name, H5T_FLOAT);
  double value = 0.0;
  must(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value), "cannot read attribute " + name);
  return value;
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const Hdf5Id attribute = open_attribute(object, name, H5T_STRING);
  const Hdf5Id stored(H5Aget_type(attribute.get()), H5Tclose, "attribute " + name + " has no type");
  if (H5Tis_variable_str(stored.get()) != 0)
    throw std::runtime_error("attribute " + name + " is of the wrong kind");
  const std::size_t size = H5Tget_size(stored.get());
  const Hdf5Id type = text_type(size + 1);
  std::string value(size + 1, '\0');
  must(H5Aread(attribute.get(), type.get(), value.data()), "cannot read attribute " + name);
  value.resize(std::strlen(value.c_str()));
  return value;
}

Hdf5Id write_dataset(hid_t parent, const std::string& name, const std::vector<double>& values,
                     const std::vector<hsize_t>& shape, hid_t type) {
  const Hdf5Id space = dataspace(shape);
  Hdf5Id dataset(H5Dcreate2(parent, name.c_str(), type, space.get(), H5P_DEFAULT,
                            timeless(H5P_DATASET_CREATE).get(), H5P_DEFAULT),
                 H5Dclose, "cannot create dataset " + name);
  if (!values.empty()) {
    must(H5Dwrite(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
         "cannot write dataset " + name);
  }
  return dataset;
}

Hdf5Id open_dataset(hid_t parent, const std::string& name) {
  return {H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "has no dataset " + name};
}

hsize_t dataset_length(hid_t dataset, const std::string& name) {
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose, "dataset " + name + " has no shape");
  if (H5Sget_simple_extent_ndims(space.get()) != 1) {
    throw std::runtime_error("dataset " + name + " is not one-dimensional");
  }
  hsize_t length = 0;
  H5Sget_simple_extent_dims(space.get(), &length, nullptr);
  return length;
}

std::vector<double> read_dataset(hid_t dataset, const std::string& name, const std::vector<hsize_t>& shape) {
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose, "dataset " + name + " has no shape");
  const Hdf5Id type(H5Dget_type(dataset), H5Tclose, "dataset " + name + " has no type");
  std::vector<hsize_t> found(shape.size());
  if (H5Tget_class(type.get()) != H5T_FLOAT || H5Tget_size(type.get()) != sizeof(double)) {
    throw std::runtime_error("dataset " + name + " does not hold 64-bit floats");
  }
  if (H5Sget_simple_extent_ndims(space.get()) != static_cast<int>(shape.size()) ||
      H5Sget_simple_extent_dims(space.get(), found.data(), nullptr) < 0 || found != shape) {
    throw std::runtime_error("dataset " + name + " has another shape than blocks and grid say");
  }
  std::vector<double> values(std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>()));
  if (!values.empty()) {
    must(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
         "cannot read dataset " + name);
  }
  return values;
}

}  // namespace softwall::analysis
