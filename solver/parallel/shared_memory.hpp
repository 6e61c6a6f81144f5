#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "solver/case/file_descriptor.hpp"
#include "solver/parallel/mpi.hpp"

/// Memory that the ranks on one machine read and write in place, instead of sending each other copies.
namespace softwall::parallel {

enum class Way {
  kBest,      ///< in place, where the ranks can share memory, otherwise by messages
  kMessages,  ///< by messages, wherever the ranks are
};

/// A mapping of a file into memory, undone with its owner. It outlives the descriptor it was made from.
class Mapping {
 public:
  /// The first `bytes` of a file, for reading and writing; data() is null where the system refuses.
  Mapping(const FileDescriptor& file, std::size_t bytes);
  Mapping(Mapping&& other) noexcept
      : address_(std::exchange(other.address_, nullptr)), bytes_(other.bytes_) {}
  Mapping& operator=(Mapping&&) = delete;
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  ~Mapping();

  [[nodiscard]] std::byte* data() const { return address_; }

 private:
  std::byte* address_ = nullptr;
  std::size_t bytes_;
};

/// Collective. Allocates `bytes` (uninitialised) on this rank and returns a mapping of the allocation of
/// every rank of `line`, in rank order. Returns nothing, on every rank, where one of them cannot reach the
/// memory of another (on another machine, in a container of its own) or has none left. The memory has no name
/// that could outlive a killed run.
[[nodiscard]] std::optional<std::vector<Mapping>> share_memory(const Communicator& line, std::size_t bytes);

/// Collective. What each rank of `line` has written to shared memory before this call, all of them read after
/// it.
void meet(const Communicator& line);

}  // namespace softwall::parallel
