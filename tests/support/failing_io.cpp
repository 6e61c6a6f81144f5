// A library for LD_PRELOAD: lets calls for files fail that the system would have done. It changes nothing
// unless FAILING_IO names a file. As long as that file is there, its one line says which calls fail, for
// instance
//
//     softwall-dns 1 write ENOSPC /checkpoints/ 3 2
//
// In the program softwall-dns, on MPI rank 1 ("-": on any, also where there is no MPI), of the calls that
// write to a file with
// "/checkpoints/" in its name, the third and the one after it, counted in each process anew, return ENOSPC.
// Calls are write, sync, rename and create; SHORT in place of an error writes half of what was asked, as a
// disk does just before it is full. What has failed is told in FAILING_IO.struck, a line a call.
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

struct Fault {
  std::array<char, 32> program{}, rank{}, call{}, error{};
  std::array<char, 256> path{};
  long first = 0, count = 0;
};

/// Past the functions below, which must not ask themselves.
bool read_fault(Fault& fault) {
  const char* const name = std::getenv("FAILING_IO");
  if (name == nullptr) return false;
  const long file = syscall(SYS_openat, AT_FDCWD, name, O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  std::array<char, 512> text{};
  const long length = syscall(SYS_read, file, text.data(), text.size() - 1);
  syscall(SYS_close, file);
  return length > 0 && std::sscanf(text.data(), "%31s %31s %31s %31s %255s %ld %ld", fault.program.data(),
                                   fault.rank.data(), fault.call.data(), fault.error.data(),
                                   fault.path.data(), &fault.first, &fault.count) == 7;
}

bool is_here(const Fault& fault) {
  const char* const rank = std::getenv("OMPI_COMM_WORLD_RANK");
  const std::string_view here = rank == nullptr ? "-" : rank, wanted = fault.rank.data();
  return std::string_view(program_invocation_short_name) == fault.program.data() &&
         (wanted == "-" || wanted == here);
}

void tell(std::string_view call, std::string_view path) {
  const std::string file = std::string(std::getenv("FAILING_IO")) + ".struck";
  const std::string line = std::string(call) + " " + std::string(path) + "\n";
  const long out =
      syscall(SYS_openat, AT_FDCWD, file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (out < 0) return;
  syscall(SYS_write, out, line.data(), line.size());
  syscall(SYS_close, out);
}

constexpr int kShort = -1;

int number_of(std::string_view error) {
  if (error == "SHORT") return kShort;
  if (error == "ENOSPC") return ENOSPC;
  if (error == "EDQUOT") return EDQUOT;
  return EIO;
}

/// 0: the call is to be done; an error number, or kShort.
int trouble_with(std::string_view call, const char* path) {
  static long seen = 0;
  Fault fault;
  if (!read_fault(fault)) {
    seen = 0;
    return 0;
  }
  if (call != fault.call.data() || !is_here(fault)) return 0;
  if (std::strstr(path, fault.path.data()) == nullptr) return 0;
  ++seen;
  if (seen < fault.first || seen >= fault.first + fault.count) return 0;
  tell(call, path);
  return number_of(fault.error.data());
}

int trouble_with(std::string_view call, int descriptor) {
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  std::array<char, 4096> path{};
  const int error = errno;
  const bool known = readlink(link.c_str(), path.data(), path.size() - 1) > 0;
  errno = error;
  return known ? trouble_with(call, path.data()) : 0;
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int fail(int error) {
  errno = error == kShort ? EIO : error;
  return -1;
}

/// Does what `write` does with as many bytes as are allowed.
template <class Write>
ssize_t write_or_fail(int file, std::size_t size, Write write) {
  const int error = trouble_with("write", file);
  if (error == kShort && size > 1) return write(size / 2);
  return error == 0 ? write(size) : fail(error);
}

/// Several pieces at once: half of the first one, or nothing.
template <class Write>
ssize_t write_pieces_or_fail(int file, const iovec* pieces, int count, Write write) {
  const int error = trouble_with("write", file);
  if (error == 0) return write(pieces, count);
  if (error != kShort || count < 1) return fail(error);
  const iovec half{pieces->iov_base, (pieces->iov_len + 1) / 2};
  return write(&half, 1);
}

using Open = int(const char*, int, mode_t);

/// `more`: the mode, where the flags say that there is one.
int open_or_fail(Open* next, const char* path, int flags, va_list more) {
  const bool makes_one = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
  const mode_t mode = makes_one ? va_arg(more, mode_t) : 0;
  const int error = (flags & O_CREAT) == 0 ? 0 : trouble_with("create", path);
  return error == 0 ? next(path, flags, mode) : fail(error);
}

}  // namespace

extern "C" {

ssize_t write(int file, const void* data, std::size_t size) {
  static const auto next = real<decltype(write)>("write");
  return write_or_fail(file, size, [&](std::size_t bytes) { return next(file, data, bytes); });
}

ssize_t pwrite(int file, const void* data, std::size_t size, off_t at) {
  static const auto next = real<decltype(pwrite)>("pwrite");
  return write_or_fail(file, size, [&](std::size_t bytes) { return next(file, data, bytes, at); });
}

ssize_t pwrite64(int file, const void* data, std::size_t size, off64_t at) {
  static const auto next = real<decltype(pwrite64)>("pwrite64");
  return write_or_fail(file, size, [&](std::size_t bytes) { return next(file, data, bytes, at); });
}

ssize_t writev(int file, const iovec* pieces, int count) {
  static const auto next = real<decltype(writev)>("writev");
  return write_pieces_or_fail(file, pieces, count,
                              [&](const iovec* some, int n) { return next(file, some, n); });
}

ssize_t pwritev(int file, const iovec* pieces, int count, off_t at) {
  static const auto next = real<decltype(pwritev)>("pwritev");
  return write_pieces_or_fail(file, pieces, count,
                              [&](const iovec* some, int n) { return next(file, some, n, at); });
}

ssize_t pwritev64(int file, const iovec* pieces, int count, off64_t at) {
  static const auto next = real<decltype(pwritev64)>("pwritev64");
  return write_pieces_or_fail(file, pieces, count,
                              [&](const iovec* some, int n) { return next(file, some, n, at); });
}

int fsync(int file) {
  static const auto next = real<decltype(fsync)>("fsync");
  const int error = trouble_with("sync", file);
  return error == 0 ? next(file) : fail(error);
}

int fdatasync(int file) {
  static const auto next = real<decltype(fdatasync)>("fdatasync");
  const int error = trouble_with("sync", file);
  return error == 0 ? next(file) : fail(error);
}

int rename(const char* from, const char* to) noexcept {
  static const auto next = real<decltype(rename)>("rename");
  const int error = trouble_with("rename", from);
  return error == 0 ? next(from, to) : fail(error);
}

int open(const char* path, int flags, ...) {
  static const auto next = real<Open>("open");
  va_list more;
  va_start(more, flags);
  const int file = open_or_fail(next, path, flags, more);
  va_end(more);
  return file;
}

int open64(const char* path, int flags, ...) {
  static const auto next = real<Open>("open64");
  va_list more;
  va_start(more, flags);
  const int file = open_or_fail(next, path, flags, more);
  va_end(more);
  return file;
}

}  // extern "C"
