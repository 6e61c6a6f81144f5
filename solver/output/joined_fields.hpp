#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace softwall::output {

/// A field of several components that are datasets of the same shape in the file already.
struct JoinedField {
  std::string name, description;
  std::vector<std::string> components;
};

/// Adds to a closed HDF5 file, for each of these, a dataset with the components along one more, last
/// dimension: a view (HDF5's virtual dataset, version 1.10 on), so that no number is stored twice. On one
/// rank. Throws std::runtime_error.
void join_fields(const std::filesystem::path& file, const std::vector<JoinedField>& fields);

}  // namespace softwall::output
