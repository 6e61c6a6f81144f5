#include "solver/output/agree.hpp"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <limits>
#include <optional>
#include <system_error>
#include <thread>

#include "solver/case/atomic_file.hpp"

namespace softwall::output {

namespace {

/// How long a rank that gives up leaves the word to rank 0, which may have failed for the same reason.
constexpr std::chrono::milliseconds kForRankZero{500};

std::string broadcast(const parallel::Communicator& all, std::string text, int root) {
  auto size = static_cast<int>(text.size());
  parallel::check(MPI_Bcast(&size, 1, MPI_INT, root, all.get()), "MPI_Bcast");
  text.resize(static_cast<std::size_t>(size));
  parallel::check(MPI_Bcast(text.data(), size, MPI_CHAR, root, all.get()), "MPI_Bcast");
  return text;
}

}  // namespace

std::string from_root(const parallel::Communicator& all, std::string text) {
  return broadcast(all, std::move(text), 0);
}

ExitCode exit_code_of(const std::exception& error, ExitCode otherwise) {
  if (const auto* agreed = dynamic_cast<const AgreedError*>(&error)) return agreed->code;
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  if (system == nullptr) return otherwise;
  if (is_trouble_of_disk(system->code())) return ExitCode::kIoFailure;
  switch (system->code().default_error_condition().value()) {
    case EACCES:
    case EPERM:
    case ENOENT:
    case ENOTDIR:
      return ExitCode::kIoFailure;
    default:
      return otherwise;
  }
}

void agree(const parallel::Communicator& all, ExitCode code, const std::function<void()>& work) {
  constexpr int kNobody = std::numeric_limits<int>::max();
  std::optional<std::string> message;
  try {
    work();
  } catch (const std::exception& error) {
    code = exit_code_of(error, code);
    message = error.what();
  }
  const int mine = message ? all.rank() : kNobody;
  int failed = kNobody;
  parallel::check(MPI_Allreduce(&mine, &failed, 1, MPI_INT, MPI_MIN, all.get()), "MPI_Allreduce");
  if (failed == kNobody) return;
  auto value = static_cast<int>(code);
  parallel::check(MPI_Bcast(&value, 1, MPI_INT, failed, all.get()), "MPI_Bcast");
  throw AgreedError(static_cast<ExitCode>(value), broadcast(all, message.value_or(""), failed));
}

void agree_on_root(const parallel::Communicator& all, ExitCode code, const std::function<void()>& work) {
  agree(all, code, [&] {
    if (all.rank() == 0) work();
  });
}

void abort_all(const parallel::Communicator& all, ExitCode code, const std::string& message) {
  if (all.rank() != 0) std::this_thread::sleep_for(kForRankZero);
  std::fprintf(stderr, "softwall-dns: rank %d: %s\n", all.rank(), message.c_str());
  std::fflush(stderr);
  MPI_Abort(all.get(), static_cast<int>(code));
  std::_Exit(static_cast<int>(code));  // not reached; the compiler cannot know
}

}  // namespace softwall::output
