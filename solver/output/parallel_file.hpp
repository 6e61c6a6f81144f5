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

/// A new HDF5 file that all ranks write together. All functions are collective. A rank on which a call fails
/// removes the file, says so, and ends the program with MPI_Abort(75): the others may wait for it inside
/// HDF5, where no agreement reaches them, closing a parallel file after an error hangs or crashes (HDF5
/// 1.10.8, measured), and a file that is not published is not missed. What a rank writes on its
/// own, metadata, is seen to at once: after a failure HDF5 goes on to collective calls that the others never
/// come to (H5Fflush and H5Fclose, measured). One file at a time.
class ParallelFile {
 public:
  /// What MPI is asked to write by this rank alone, and wrote: gives up where that is less.
  static void require_written(std::int64_t asked, std::int64_t written);

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
  [[noreturn]] void give_up(const std::string& what, const std::string& reason) const;
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
