#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// spectra.h5: arrays by name, each with its meaning. The solver writes it, the plotting scripts read it.
namespace softwall::analysis {

struct NamedArray {
  std::string group, name;
  std::string unit;  ///< in h, U_b, rho; "1" when dimensionless
  std::string description;
  std::vector<std::size_t> shape;
  std::vector<double> values;  ///< row major
  bool exact = false;          ///< whether the file keeps all digits, not only those of single precision
};

/// Replace `path` by these arrays, sealed and published as statistics.h5 is (statistics_file.hpp). MPI need
/// not be initialised. Throws std::runtime_error naming the file and what is wrong.
void write_arrays(const std::filesystem::path& path, const std::string& case_id,
                  const std::vector<NamedArray>& arrays);

}  // namespace softwall::analysis
