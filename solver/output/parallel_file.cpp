#include "solver/output/parallel_file.hpp"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "solver/case/atomic_file.hpp"
#include "solver/output/agree.hpp"

namespace softwall::output {

namespace {

using analysis::Hdf5Id;
using analysis::must;

Hdf5Id property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose, "cannot create a property list"}; }

hid_t create_file(const std::filesystem::path& path, MPI_Comm comm, std::int64_t user_block) {
  const Hdf5Id creation = property_list(H5P_FILE_CREATE), access = property_list(H5P_FILE_ACCESS);
  must(H5Pset_userblock(creation.get(), static_cast<hsize_t>(user_block)), "cannot set the user block");
  must(H5Pset_obj_track_times(creation.get(), false), "cannot leave out the time stamps");
  must(H5Pset_fapl_mpio(access.get(), comm, MPI_INFO_NULL), "cannot choose parallel access");
  must(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110), "cannot choose the format");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get());
  must(file < 0 ? -1 : 0, "cannot create the file");
  return file;
}

/// The file that is being written; HDF5 hands nothing through to the function at the end that would lead
/// there.
const ParallelFile* at_work = nullptr;

Hdf5Id create_dataset(hid_t file, const std::string& name, hid_t type, hid_t space) {
  const Hdf5Id creation = property_list(H5P_DATASET_CREATE);
  must(H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER), "cannot leave out the fill values");
  must(H5Pset_obj_track_times(creation.get(), false), "cannot leave out the time stamps");
  return {H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Dclose,
          "cannot create " + name};
}

/// This rank's cells in the order of the file.
std::vector<grid::Real> packed(const grid::Field& field, int rows) {
  std::vector<grid::Real> values;
  values.reserve(static_cast<std::size_t>(field.nx()) * static_cast<std::size_t>(rows) *
                 static_cast<std::size_t>(field.nz()));
  const auto q = field.view();
  for (int k = 0; k < field.nz(); ++k) {
    for (int j = 0; j < rows; ++j) values.insert(values.end(), &q(0, j, k), &q(0, j, k) + field.nx());
  }
  return values;
}

}  // namespace

/// Shape of a dataset and the part of it that this rank writes.
struct ParallelFile::Selection {
  std::vector<hsize_t> shape, start, count;

  [[nodiscard]] Hdf5Id file_space() const {
    return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose,
            "cannot create a dataspace"};
  }
  [[nodiscard]] bool empty() const { return std::count(count.begin(), count.end(), hsize_t{0}) > 0; }
  void select(hid_t space) const {
    if (empty()) return must(H5Sselect_none(space), "cannot select nothing");
    must(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
         "cannot select this rank's part");
  }
  [[nodiscard]] Hdf5Id memory_space() const {
    return {H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose,
            "cannot create a dataspace"};
  }
};

ParallelFile::ParallelFile(std::filesystem::path path, const parallel::Communicator& all,
                           std::int64_t user_block)
    : path_(std::move(path)), all_(all) {
  step("create", [&] {
    file_ = create_file(path_, all_.get(), user_block);
    at_work = this;
    collective_.emplace(property_list(H5P_DATASET_XFER));
    must(H5Pset_dxpl_mpio(collective_->get(), H5FD_MPIO_COLLECTIVE), "cannot choose collective writes");
    on_disk_ = FileDescriptor(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
  });
}

void ParallelFile::give_up(const std::string& what, const std::string& reason) const {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);  // on a full disk others need its room
  abort_all(all_, ExitCode::kIoFailure, "cannot " + what + " " + path_.string() + ": " + reason);
}

void ParallelFile::require_written(std::int64_t asked, std::int64_t written) {
  if (written == asked || at_work == nullptr) return;
  at_work->give_up("write", std::to_string(std::max(written, std::int64_t{0})) + " of " +
                                std::to_string(asked) + " bytes were written");
}

void ParallelFile::step(const std::string& what, const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    give_up(what, error.what());
  }
}

void ParallelFile::create_group(const std::string& name) {
  step("write", [&] {
    const Hdf5Id creation = property_list(H5P_GROUP_CREATE);
    must(H5Pset_obj_track_times(creation.get(), false), "cannot leave out the time stamps");
    const Hdf5Id group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose,
                       "cannot create group " + name);
  });
}

void ParallelFile::write(const Label& label, hid_t type, const Selection& selection, const void* data) {
  // The dataset outlives the step that writes it: after an error nothing is closed.
  std::optional<Hdf5Id> dataset;
  const Hdf5Id space = selection.file_space();
  step("write", [&] {
    dataset.emplace(create_dataset(file_, label.name, type, space.get()));
    analysis::write_attribute(dataset->get(), "description", label.description);
  });
  step("write", [&] {
    selection.select(space.get());
    const Hdf5Id memory = selection.memory_space();
    if (selection.empty()) must(H5Sselect_none(memory.get()), "cannot select nothing");
    must(H5Dwrite(dataset->get(), type, memory.get(), space.get(), collective_->get(), data),
         ("cannot write " + label.name).c_str());
  });
}

void ParallelFile::write_field(const Label& label, const grid::Field& field, int rows, const grid::Grid& g) {
  const auto size = [](int n) { return static_cast<hsize_t>(n); };
  const Selection selection{{size(g.nz_global), size(rows), size(g.nx_global)},
                            {size(g.z_begin), 0, size(g.x_begin)},
                            {size(g.nz), size(rows), size(g.nx)}};
  write(label, sizeof(grid::Real) == sizeof(float) ? H5T_IEEE_F32LE : H5T_IEEE_F64LE, selection,
        packed(field, rows).data());
  begin_write_out(on_disk_.get());  // while the next field is packed, and the digest found
}

void ParallelFile::write_values(const Label& label, std::span<const double> values) {
  const hsize_t mine = all_.rank() == 0 ? values.size() : 0;
  write(label, H5T_IEEE_F64LE, {{values.size()}, {0}, {mine}}, values.data());
}

void ParallelFile::write_values_of_root(const Label& label, std::span<const double> values) {
  const bool root = all_.rank() == 0;
  std::uint64_t size = values.size();
  parallel::check(MPI_Bcast(&size, 1, MPI_UINT64_T, 0, all_.get()), "MPI_Bcast");
  write(label, H5T_IEEE_F64LE, {{size}, {0}, {root ? size : 0}}, values.data());
}

void ParallelFile::write_number(const Label& label, double value) { write_values(label, {&value, 1}); }

void ParallelFile::write_integer(const Label& label, std::int64_t value) {
  const hsize_t mine = all_.rank() == 0 ? 1 : 0;
  write(label, H5T_STD_I64LE, {{1}, {0}, {mine}}, &value);
}

void ParallelFile::close() {
  step("flush", [&] { must(H5Fflush(file_, H5F_SCOPE_GLOBAL), "cannot flush"); });
  step("close", [&] { must(H5Fclose(file_), "cannot close"); });
  at_work = nullptr;
}

}  // namespace softwall::output

/// MPI's profiling interface: what HDF5 calls is this, and it does its work by PMPI_File_write_at. Open MPI's
/// files (4.1, measured) tell of a failed write only by the number of bytes.
extern "C" int MPI_File_write_at(MPI_File file, MPI_Offset offset, const void* data, int count,
                                 MPI_Datatype type, MPI_Status* status) {
  MPI_Status own;
  MPI_Status* const outcome = status == MPI_STATUS_IGNORE ? &own : status;
  const int error = PMPI_File_write_at(file, offset, data, count, type, outcome);
  int written = 0, bytes = 0;
  MPI_Get_count(outcome, type, &written);
  MPI_Type_size(type, &bytes);
  const std::int64_t whole = std::int64_t{count} * bytes;
  softwall::output::ParallelFile::require_written(whole,
                                                  error == MPI_SUCCESS ? written * std::int64_t{bytes} : 0);
  return error;
}

namespace softwall::output {

void prepare_hdf5() {
  ::setenv("HDF5_USE_FILE_LOCKING", "FALSE",
           0);  // fails on some network file systems, and nothing here needs it
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace softwall::output
