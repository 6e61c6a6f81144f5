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

/// Collective: the memory of every rank of `line`, in their order; of this one's there are `bytes`, with
/// anything in them. Nothing, on every rank, where one of them cannot reach the memory of another (another
/// machine, a container of its own) or has none left. It has no name that could outlive a killed run.
[[nodiscard]] std::optional<std::vector<Mapping>> share_memory(const Communicator& line, std::size_t bytes);

/// Collective: what each rank of `line` has written to shared memory before, every one reads after.
void meet(const Communicator& line);

}  // namespace softwall::parallel
