#pragma once

#include <hdf5.h>

#include <string>
#include <string_view>
#include <vector>

/// Owners and checked calls for HDF5 files that live in memory (core driver): no MPI, no file system.
/// Failures throw std::runtime_error with the object's name and HDF5's own reason.
namespace softwall::analysis {

/// One HDF5 identifier, closed by the function that belongs to its kind.
class Hdf5Id {
 public:
  using Close = herr_t (*)(hid_t);
  /// Takes ownership of `id`; throws when it is invalid, saying that `what` failed.
  Hdf5Id(hid_t id, Close close, const std::string& what);
  Hdf5Id(Hdf5Id&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = H5I_INVALID_HID; }
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;
  Hdf5Id& operator=(Hdf5Id&&) = delete;
  ~Hdf5Id();
  [[nodiscard]] hid_t get() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// While one lives, HDF5 prints no error stack: the reason travels in the exception instead.
class QuietHdf5 {
 public:
  QuietHdf5();
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;
  ~QuietHdf5();

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// Throws when a call of HDF5 has failed: `what` and HDF5's own reason.
void must(herr_t status, const std::string& what);

[[nodiscard]] Hdf5Id create_image();
[[nodiscard]] Hdf5Id open_image(std::string_view bytes);
[[nodiscard]] std::string image_bytes(const Hdf5Id& file);

[[nodiscard]] Hdf5Id create_group(hid_t parent, const std::string& name);
[[nodiscard]] Hdf5Id open_group(hid_t parent, const std::string& name);
[[nodiscard]] std::vector<std::string> member_names(hid_t group);

void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, const std::string& value);
[[nodiscard]] double read_number_attribute(hid_t object, const std::string& name);
[[nodiscard]] std::string read_text_attribute(hid_t object, const std::string& name);

/// Doubles in the shape given, on disk as `type`.
[[nodiscard]] Hdf5Id write_dataset(hid_t parent, const std::string& name, const std::vector<double>& values,
                                   const std::vector<hsize_t>& shape, hid_t type = H5T_IEEE_F64LE);
/// Throws unless the dataset holds 64-bit floats in exactly this shape.
[[nodiscard]] std::vector<double> read_dataset(hid_t dataset, const std::string& name,
                                               const std::vector<hsize_t>& shape);
[[nodiscard]] Hdf5Id open_dataset(hid_t parent, const std::string& name);
/// Length of a one-dimensional dataset.
[[nodiscard]] hsize_t dataset_length(hid_t dataset, const std::string& name);

}  // namespace softwall::analysis
