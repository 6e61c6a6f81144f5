#pragma once

#include <string>

/// Requests to stop in order: SIGUSR1, SIGTERM, SIGINT, SIGHUP.
namespace softwall {

/// To be called before MPI_Init: mpirun forwards SIGUSR1 at any moment, and by default it kills. One of
/// the others that was ignored stays ignored (nohup). Also ignores what must not end a run: SIGPIPE (the
/// reader of our output is gone) and SIGXFSZ (a file size limit; the write then fails with an error that is
/// reported).
void install_signal_handlers();

/// Number of the signal that asked this process to stop; 0: none did.
[[nodiscard]] int stop_signal();

/// Why a run ends that such a signal stops, for users: "stopped on request".
[[nodiscard]] std::string describe_stop_signal(int signal);

}  // namespace softwall
