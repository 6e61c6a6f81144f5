#pragma once

#include "solver/case/file_descriptor.hpp"
#include "solver/parallel/mpi.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::output {

/// Keeps a second solver out of a run directory: rank 0 holds an flock on solver.lock, which dies with the
/// process. Collective. Waits up to five seconds (a killed mpirun leaves ranks for about one), then throws
/// AgreedError (1).
class RunLock {
 public:
  RunLock(const RunFiles& run, const parallel::Communicator& all);

 private:
  FileDescriptor descriptor_;
};

}  // namespace softwall::output
