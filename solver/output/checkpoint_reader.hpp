#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "solver/output/checkpoint_contents.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "solver/run_directory/hdf5_image.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::output {

/// Columns of a field of the file, in global indices; all rows.
struct Columns {
  int x_begin = 0, nx = 0, z_begin = 0, nz = 0;
};

/// A checkpoint opened by one rank for itself: reading needs no other rank, so none can hang. Open only what
/// verify_checkpoint() has found valid: HDF5 may crash on damaged files. Throws std::runtime_error.
class CheckpointFile {
 public:
  explicit CheckpointFile(const std::filesystem::path& path);

  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] std::int64_t integer(const std::string& name) const;
  [[nodiscard]] std::vector<double> values(const std::string& name) const;

  /// Whether a group has a member of this name: files of earlier versions lack some.
  [[nodiscard]] bool has(const std::string& group, const std::string& name) const;

  /// What stands beside the accumulators of Statistics, by name.
  [[nodiscard]] std::map<std::string, std::vector<double>> more_statistics() const;

  /// {nz, rows, nx} of a field.
  [[nodiscard]] std::array<int, 3> extents(const std::string& field) const;
  /// The cells of these columns as [nz][rows][nx].
  [[nodiscard]] std::vector<double> columns(const std::string& field, const Columns& which) const;

 private:
  analysis::Hdf5Id file_;
};

/// Fills the state and returns the record. Collective: throws AgreedError (77), with both values where two do
/// not agree, unless the file is of exactly this grid, step and time. Ghost cells are left to time::start().
[[nodiscard]] CheckpointContents load_checkpoint(const std::filesystem::path& file,
                                                 const CheckpointHeader& header, const time::Setup& setup,
                                                 time::State& state);

}  // namespace softwall::output
