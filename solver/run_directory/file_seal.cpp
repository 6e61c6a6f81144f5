#include "solver/run_directory/file_seal.hpp"

#include <xxhash.h>

#include "solver/case/hexadecimal.hpp"

#include <stdexcept>

namespace softwall::analysis {
namespace {

constexpr std::string_view kFirstLine = "softwall statistics, format 1, HDF5 follows after 512 bytes\n";

}  // namespace

std::string seal_for(std::string_view contents) {
  std::string seal = std::string(kFirstLine) + "bytes " + std::to_string(contents.size()) + "\nxxh3 " +
                     hexadecimal(XXH3_64bits(contents.data(), contents.size())) + "\n";
  seal.resize(kSealBytes - 1, ' ');
  return seal + '\n';
}

std::string_view open_seal(std::string_view file) {
  if (file.size() < kSealBytes) {
    throw std::runtime_error("is only " + std::to_string(file.size()) +
                             " bytes long: empty, cut off, or not a statistics file");
  }
  if (!file.starts_with(kFirstLine)) {
    throw std::runtime_error("does not begin with \"" +
                             std::string(kFirstLine.substr(0, kFirstLine.size() - 1)) +
                             "\": not a statistics file, or written by another version of softwall");
  }
  const std::string_view contents = file.substr(kSealBytes);
  if (file.substr(0, kSealBytes) != seal_for(contents)) {
    throw std::runtime_error("is damaged: length or checksum differ from what was written");
  }
  return contents;
}

}  // namespace softwall::analysis
