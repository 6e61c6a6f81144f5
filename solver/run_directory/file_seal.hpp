#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// A seal is the first 512 bytes of statistics.h5: plain text that says how many bytes follow and their
/// XXH3-64 digest. HDF5 1.10 can crash on a damaged file, so no byte reaches it before the seal has been
/// checked; to HDF5 the seal is a user block, which every reader (h5py, h5dump) skips.
namespace softwall::analysis {

inline constexpr std::size_t kSealBytes = 512;  ///< smallest user block that HDF5 looks behind

[[nodiscard]] std::string seal_for(std::string_view contents);

/// The contents behind the seal. Throws std::runtime_error (what is wrong, without the file's name) when the
/// seal is missing, of another version, or does not fit what follows.
[[nodiscard]] std::string_view open_seal(std::string_view file);

}  // namespace softwall::analysis
