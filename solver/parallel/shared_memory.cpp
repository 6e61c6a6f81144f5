#include "solver/parallel/shared_memory.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace softwall::parallel {

namespace {

/// Says where other processes can open a rank's memory, and the token by which they know that it is the right
/// one.
struct Address {
  std::int64_t process = 0, descriptor = -1, bytes = 0, token = 0;
};
constexpr const char* kName = "softwall";
constexpr int kNumbers = sizeof(Address) / sizeof(std::int64_t);

bool on_one_machine(const Communicator& line) {
  MPI_Comm machine = MPI_COMM_NULL;
  check(MPI_Comm_split_type(line.get(), MPI_COMM_TYPE_SHARED, line.rank(), MPI_INFO_NULL, &machine),
        "MPI_Comm_split_type");
  return Communicator(machine).size() == line.size();
}

bool all_agree(const Communicator& line, bool mine) {
  int all = mine ? 1 : 0;
  check(MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, line.get()), "MPI_Allreduce");
  return all == 1;
}

/// The memory is there when this returns: later it could only be missed by a crash.
FileDescriptor anonymous_file(std::size_t bytes) {
  FileDescriptor file(memfd_create(kName, MFD_CLOEXEC));
  int error = EINTR;
  while (file && error == EINTR) error = posix_fallocate(file.get(), 0, static_cast<off_t>(bytes));
  if (error != 0) return FileDescriptor();
  return file;
}

/// A process number may mean somebody else in another container: nothing is opened but what looks like memory
/// of this program, and its size must be right.
FileDescriptor open_of(const Address& owner) {
  const std::string path =
      "/proc/" + std::to_string(owner.process) + "/fd/" + std::to_string(owner.descriptor);
  std::error_code nobody;
  const std::string target = std::filesystem::read_symlink(path, nobody).string();
  if (!target.starts_with(std::string("/memfd:") + kName)) return FileDescriptor();
  FileDescriptor file(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
  struct stat found {};
  if (!file || fstat(file.get(), &found) != 0 || found.st_size != owner.bytes) return FileDescriptor();
  return file;
}

bool begins_with(const Mapping& memory, std::int64_t token) {
  return memory.data() && std::memcmp(memory.data(), &token, sizeof token) == 0;
}

}  // namespace

Mapping::Mapping(const FileDescriptor& file, std::size_t bytes) : bytes_(bytes) {
  if (!file) return;
  void* const found = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.get(), 0);
  if (found != MAP_FAILED) address_ = static_cast<std::byte*>(found);
}

Mapping::~Mapping() {
  if (address_) munmap(address_, bytes_);
}

/// Each rank opens the files of the others through /proc. What is found there must begin with what its owner
/// says it wrote.
std::optional<std::vector<Mapping>> share_memory(const Communicator& line, std::size_t bytes) {
  if (!on_one_machine(line)) return std::nullopt;
  Address mine;
  bytes = std::max(bytes, sizeof mine.token);
  const FileDescriptor file = anonymous_file(bytes);
  const Mapping memory(file, bytes);
  mine.process = getpid();
  mine.descriptor = file.get();
  mine.bytes = static_cast<std::int64_t>(bytes);
  std::random_device random;
  mine.token = static_cast<std::int64_t>(std::uint64_t(random()) << 32 | random());
  if (memory.data()) std::memcpy(memory.data(), &mine.token, sizeof mine.token);

  std::vector<Address> owners(static_cast<std::size_t>(line.size()));
  check(MPI_Allgather(&mine, kNumbers, MPI_INT64_T, owners.data(), kNumbers, MPI_INT64_T, line.get()),
        "MPI_Allgather");
  std::vector<Mapping> all;
  for (const Address& owner : owners) all.emplace_back(open_of(owner), static_cast<std::size_t>(owner.bytes));
  bool found = true;
  for (std::size_t r = 0; r < owners.size(); ++r) found = found && begins_with(all[r], owners[r].token);
  if (!all_agree(line, found)) return std::nullopt;
  return all;
}

void meet(const Communicator& line) {
  std::atomic_thread_fence(std::memory_order_seq_cst);
  check(MPI_Barrier(line.get()), "MPI_Barrier");
  std::atomic_thread_fence(std::memory_order_seq_cst);
}

}  // namespace softwall::parallel
