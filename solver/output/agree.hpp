#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "solver/parallel/mpi.hpp"
#include "solver/run_directory/exit_codes.hpp"

/// Errors that all ranks know of. An error on one rank alone, thrown past a collective call, leaves the
/// others waiting indefinitely; so whatever one rank does on its own is followed by an agreement.
namespace softwall::output {

/// An error thrown on every rank at once: the program may end in order, with this exit code.
struct AgreedError : std::runtime_error {
  AgreedError(ExitCode exit_code, const std::string& message)
      : std::runtime_error(message), code(exit_code) {}
  ExitCode code;
};

/// Runs `work` on every rank. When it throws on any, throws AgreedError on all with the message of the lowest
/// such rank; `code` is used unless that rank threw an AgreedError itself, or an error of the disk (75).
void agree(const parallel::Communicator& all, ExitCode code, const std::function<void()>& work);

/// Runs on rank 0 alone what all ranks must know the outcome of.
void agree_on_root(const parallel::Communicator& all, ExitCode code, const std::function<void()>& work);

/// Rank 0's text, on every rank.
[[nodiscard]] std::string from_root(const parallel::Communicator& all, std::string text);

/// The exit code that tells the manager what to do about this exception: disk full and its like are 75.
[[nodiscard]] ExitCode exit_code_of(const std::exception& error, ExitCode otherwise);

/// For an error of this rank in the middle of what others wait for inside a library, where no agreement
/// reaches them: prints the message and ends all ranks with MPI_Abort. Where all have failed, rank 0 speaks.
[[noreturn]] void abort_all(const parallel::Communicator& all, ExitCode code, const std::string& message);

}  // namespace softwall::output
