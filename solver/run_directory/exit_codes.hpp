#pragma once

namespace softwall {

/// What softwall-dns says by its exit status; the manager decides by these and by summary.json.
/// Values follow sysexits.h where it has one, so that they differ from what mpirun itself returns.
enum class ExitCode : int {
  kDone = 0,        ///< end time reached, summary written
  kFailed = 1,      ///< unexpected error: retry, bounded
  kIoFailure = 75,  ///< disk full or I/O error: the last checkpoint is intact, retry later
  kDiverged = 76,   ///< non-finite or runaway field: never retry unchanged
  kCheckpointRefused =
      77,             ///< no checkpoint can be used though some exist, or the one to start from is damaged
  kBadCase = 78,      ///< case.json, command line, ranks or the start do not fit: never retry
  kInterrupted = 85,  ///< stopped on request, checkpoint written: resume me
};

}  // namespace softwall
