#include "campaign/launch/start_program.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "campaign/system/signals.hpp"
#include "campaign/system/work_marks.hpp"
#include "solver/case/file_descriptor.hpp"

namespace softwall::campaign {
namespace {

constexpr std::size_t kSessionDigits = 10;

[[noreturn]] void throw_errno(const std::string& what, int error) {
  throw std::runtime_error(what + ": " + std::strerror(error));
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

FileDescriptor open_to_append(const std::filesystem::path& log) {
  FileDescriptor opened(open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (!opened) throw_errno("cannot write " + log.string(), errno);
  return opened;
}

struct ChildSetup {
  pid_t parent;
  int input, output, errors;  ///< descriptors: standard input, log, standard error
  const char* folder;
  char* const* arguments;
  char* const* environment;
  char* session;  ///< room for the digits of kSessionVariable in the environment
  int error = 0;  ///< told by the child: why it could not become the program; 0: it has
};

/// Uses no memory from the heap, because the child must not ask for any.
void write_digits(char* room, pid_t number) {
  for (std::size_t i = kSessionDigits; i-- > 0; number /= 10) room[i] = static_cast<char>('0' + number % 10);
}

/// The child between clone and exec. It shares the memory of its parent, so it makes only system calls.
int become_program(void* given) {
  ChildSetup& setup = *static_cast<ChildSetup*>(given);
  setsid();
  write_digits(setup.session, getpid());
  prctl(PR_SET_PDEATHSIG, SIGUSR1);
  if (getppid() != setup.parent) _exit(1);  // the runner died before the line above
  restore_default_signals();
  dup2(setup.input, STDIN_FILENO);
  dup2(setup.output, STDOUT_FILENO);
  dup2(setup.errors, STDERR_FILENO);
  if (chdir(setup.folder) == 0) execve(setup.arguments[0], setup.arguments, setup.environment);
  setup.error = errno;
  _exit(127);
}

/// Starts the child as posix_spawn() does: it borrows our memory, and we stand still until it has become its
/// program. fork() would copy the page tables of a process that may hold ten thousand cases, and every page
/// written afterwards would have to be copied as well. posix_spawn() itself cannot set the signal that tells
/// of our death. All signals are blocked meanwhile, because a handler would run in the shared memory.
pid_t start_child(ChildSetup& setup) {
  constexpr std::size_t kStackBytes = 64 * 1024;
  const auto stack = std::make_unique_for_overwrite<char[]>(kStackBytes);
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &before);
  const pid_t child =
      clone(become_program, stack.get() + kStackBytes, CLONE_VM | CLONE_VFORK | SIGCHLD, &setup);
  const int error = errno;
  sigprocmask(SIG_SETMASK, &before, nullptr);
  if (child < 0) throw_errno("cannot start another process", error);
  return child;
}

}  // namespace

pid_t start_program(ProgramStart start) {
  start.environment.push_back(std::string(kSessionVariable) + "=" + std::string(kSessionDigits, '0'));
  const auto arguments = pointers_to(start.arguments);
  const auto environment = pointers_to(start.environment);
  std::string& session = start.environment.back();

  const FileDescriptor input(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const FileDescriptor output = open_to_append(start.log);
  const FileDescriptor errors = start.errors.empty() ? FileDescriptor() : open_to_append(start.errors);
  ChildSetup setup{.parent = getpid(),
                   .input = input.get(),
                   .output = output.get(),
                   .errors = errors ? errors.get() : output.get(),
                   .folder = start.folder.c_str(),
                   .arguments = arguments.data(),
                   .environment = environment.data(),
                   .session = session.data() + session.size() - kSessionDigits};
  const pid_t child = start_child(setup);
  if (setup.error != 0) {
    waitpid(child, nullptr, 0);
    throw_errno("cannot start " + start.arguments[0], setup.error);
  }
  return child;
}

int exit_code_of(int wait_status) {
  return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

}  // namespace softwall::campaign
