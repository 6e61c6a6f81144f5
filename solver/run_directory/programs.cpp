#include "solver/run_directory/programs.hpp"

namespace softwall {

std::filesystem::path solver_program(const std::filesystem::path& folder, Precision precision) {
  return folder / (precision == Precision::kSingle ? "softwall-dns-single" : "softwall-dns");
}

std::filesystem::path folder_of_this_program() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

}  // namespace softwall
