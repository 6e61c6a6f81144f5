#pragma once

#include "solver/run_directory/run_files.hpp"

namespace softwall {

/// Replaces this process by the solver of the precision that the case asks for, with the same arguments
/// (argv, ended by a null pointer); to be called before MPI_Init. Returns when this is the right program;
/// also when the case cannot be read or the other program cannot be started, which run_case() then reports on
/// one rank for all.
void become_right_program(const RunFiles& files, char** argv);

}  // namespace softwall
