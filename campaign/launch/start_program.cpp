#include "campaign/launch/start_program.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
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

struct ChildSetup {
  pid_t parent;
  int input, output, report;  ///< descriptors: standard input, log, and where an exec error is told
  const char* folder;
  char* const* arguments;
  char* const* environment;
  char* session;  ///< room for the digits of kSessionVariable in the environment
};

/// Without memory from the heap, which a child between fork and exec must not ask for.
void write_digits(char* room, pid_t number) {
  for (std::size_t i = kSessionDigits; i-- > 0; number /= 10) room[i] = static_cast<char>('0' + number % 10);
}

/// The child between fork and exec: only system calls.
[[noreturn]] void become_program(const ChildSetup& setup) {
  setsid();
  write_digits(setup.session, getpid());
  prctl(PR_SET_PDEATHSIG, SIGUSR1);
  if (getppid() != setup.parent) _exit(1);  // the runner died before the line above
  restore_default_signals();
  dup2(setup.input, STDIN_FILENO);
  dup2(setup.output, STDOUT_FILENO);
  dup2(setup.output, STDERR_FILENO);
  if (chdir(setup.folder) == 0) execve(setup.arguments[0], setup.arguments, setup.environment);
  const int error = errno;
  if (write(setup.report, &error, sizeof error) < 0) _exit(126);
  _exit(127);
}

}  // namespace

pid_t start_program(ProgramStart start) {
  start.environment.push_back(std::string(kSessionVariable) + "=" + std::string(kSessionDigits, '0'));
  const auto arguments = pointers_to(start.arguments);
  const auto environment = pointers_to(start.environment);
  std::string& session = start.environment.back();

  const FileDescriptor input(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const FileDescriptor output(open(start.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (!output) throw_errno("cannot write " + start.log.string(), errno);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_errno("cannot make a pipe", errno);
  const FileDescriptor report_in(ends[0]);
  FileDescriptor report_out(ends[1]);

  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw_errno("cannot start another process", errno);
  if (child == 0) {
    become_program({parent, input.get(), output.get(), report_out.get(), start.folder.c_str(),
                    arguments.data(), environment.data(), session.data() + session.size() - kSessionDigits});
  }
  if (!report_out.close()) throw_errno("cannot close a pipe", errno);
  int error = 0;
  if (read(report_in.get(), &error, sizeof error) > 0) {
    waitpid(child, nullptr, 0);
    throw_errno("cannot start " + start.arguments[0], error);
  }
  return child;
}

int exit_code_of(int wait_status) {
  return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

}  // namespace softwall::campaign
