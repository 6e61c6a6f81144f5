#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "solver/case/file_descriptor.hpp"
#include "solver/grid/field.hpp"
#include "solver/parallel/mpi.hpp"
#include "solver/run_directory/hdf5_image.hpp"

namespace softwall::output {

/// What a dataset is, for whoever opens the file in ten years.
struct Label {
  std::string name;  ///< path in the file: "fields/u"
  std::string description;
};

/// A new HDF5 file that all ranks write together. All functions are collective. After every HDF5 call the
/// ranks agree whether it worked; if it did not on any, one of them says so and MPI_Abort(75) ends the
/// program: closing a parallel file after an error hangs or crashes (HDF5 1.10.8, measured), and a file that
/// is not published is not missed.
class ParallelFile {
 public:
  /// Creates `path` (which is replaced) with `user_block` bytes (0, or a power of two from 512) in front.
  ParallelFile(std::filesystem::path path, const parallel::Communicator& all, std::int64_t user_block);

  void create_group(const std::string& name);
  /// The cells of all ranks as one array [nz][rows][nx], in the precision of the fields.
  void write_field(const Label& label, const grid::Field& field, int rows, const grid::Grid& grid);
  /// Numbers that are the same on every rank; rank 0 writes them.
  void write_values(const Label& label, std::span<const double> values);
  /// Numbers that rank 0 alone has.
  void write_values_of_root(const Label& label, std::span<const double> values);
  void write_number(const Label& label, double value);
  void write_integer(const Label& label, std::int64_t value);

  /// Flushes and closes; nothing may be written after it.
  void close();

 private:
  struct Selection;
  void step(const std::string& what, const std::function<void()>& work);
  void write(const Label& label, hid_t type, const Selection& selection, const void* data);

  std::filesystem::path path_;
  const parallel::Communicator& all_;
  hid_t file_ = H5I_INVALID_HID;                ///< no owner type on purpose: only close() may close it
  std::optional<analysis::Hdf5Id> collective_;  ///< transfer property list
  FileDescriptor on_disk_;                      ///< the same file, for begin_write_out()
};

/// To be called once before any other use of HDF5: nothing is closed behind our back at exit, no error stack
/// is printed.
void prepare_hdf5();

}  // namespace softwall::output
