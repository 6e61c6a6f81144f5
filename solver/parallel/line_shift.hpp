#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "solver/parallel/line_memory.hpp"
#include "solver/parallel/shared_memory.hpp"

/// How every rank of a line hands values to the next rank or to the one before, all at once.
namespace softwall::parallel {

/// With shared memory a rank reads its neighbour's values in the buffer in which the neighbour wrote them.
/// Each rank has two buffers and writes to them in turn: once all ranks have met after writing to the second,
/// nobody reads the first any more.
template <class T>
class LineShift {
 public:
  explicit LineShift(const Communicator& line, Way way = Way::kBest)
      : line_(line), may_share_(way == Way::kBest) {}

  /// Room for what this rank is going to hand on. Every rank of the line asks for equally much; collective
  /// when that is more than there is yet. Room doubles then: messages grow by a row at a time as the surface
  /// of a layer falls.
  [[nodiscard]] T* outgoing(std::size_t count) {
    if (count > room_) make_room(whole_lines<T>(std::max(count, 2 * room_)));
    count_ = count;
    return shared_ ? buffer_of(line_.rank()) : sent_.data();
  }

  /// Hands it to the rank `direction` (1 or -1) further; the first one follows the last. Returns what this
  /// rank gets, valid until the next outgoing().
  [[nodiscard]] const T* shift(int direction) {
    const int ranks = line_.size(), rank = line_.rank();
    const int next = (rank + direction + ranks) % ranks, previous = (rank - direction + ranks) % ranks;
    if (!shared_) return send(next, previous);
    meet(line_);
    const T* const incoming = buffer_of(previous);
    second_ = !second_;
    return incoming;
  }

 private:
  void make_room(std::size_t room) {
    room_ = room;
    if (may_share_) shared_ = share_memory(line_, 2 * room * sizeof(T));
    if (shared_) return;
    sent_.resize(room);
    received_.resize(room);
  }

  [[nodiscard]] T* buffer_of(int rank) const {
    T* const both = reinterpret_cast<T*>((*shared_)[static_cast<std::size_t>(rank)].data());
    return second_ ? both + room_ : both;
  }

  const T* send(int next, int previous) {
    const auto count = static_cast<int>(count_);
    check(MPI_Sendrecv(sent_.data(), count, mpi_type<T>(), next, 0, received_.data(), count, mpi_type<T>(),
                       previous, 0, line_.get(), MPI_STATUS_IGNORE),
          "MPI_Sendrecv");
    return received_.data();
  }

  const Communicator& line_;
  bool may_share_;
  std::size_t room_ = 0, count_ = 0;            ///< values: in a buffer, handed on next
  bool second_ = false;                         ///< which buffer is written next
  std::optional<std::vector<Mapping>> shared_;  ///< both buffers of every rank of the line
  LineVector<T> sent_, received_;               ///< without shared memory
};

}  // namespace softwall::parallel
