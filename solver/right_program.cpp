#include "solver/right_program.hpp"

#include <unistd.h>

#include <exception>
#include <filesystem>

#include "solver/case/case.hpp"
#include "solver/grid/grid.hpp"
#include "solver/run_directory/programs.hpp"

namespace softwall {

void become_right_program(const RunFiles& files, char** argv) {
  try {
    const Precision wanted = read_case(files.case_file()).physics.precision;
    if (wanted == grid::kPrecision) return;
    const auto other = solver_program(folder_of_this_program(), wanted);
    // A program under the other one's name would start itself for ever.
    if (std::filesystem::equivalent(other, "/proc/self/exe")) return;
    ::execv(other.c_str(), argv);
  } catch (const std::exception&) {  // run_case() says it better
  }
}

}  // namespace softwall
