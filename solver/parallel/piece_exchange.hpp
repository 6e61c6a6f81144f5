#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

#include "solver/parallel/line_memory.hpp"
#include "solver/parallel/profile.hpp"
#include "solver/parallel/shared_memory.hpp"

/// How the ranks of a line hand each other one piece of an array each, there and back.
namespace softwall::parallel {

/// Every rank has a near and a far piece for each rank. There: what it has written into near(r), rank r finds
/// in its far(of this rank). Back: the other way round. The two are called in turns; near pieces are a rank's
/// to read and write until there(), far ones from then until back(). What a rank keeps is near and far at
/// once and is never copied; in shared memory nothing is.
template <class T>
class PieceExchange {
 public:
  using Lengths = std::vector<std::size_t>;

  /// Values in the pieces, by rank of the line; near[own rank] == far[own rank]. Collective.
  PieceExchange(const Communicator& line, const Lengths& near, const Lengths& far, Profile* profile,
                Way way = Way::kBest)
      : line_(line),
        profile_(profile),
        own_(static_cast<std::size_t>(line.rank())),
        near_(near, own_),
        far_(without(own_, far), own_) {
    if (line.size() > 1 && way == Way::kBest) shared_ = share_memory(line, near_.room * sizeof(T));
    if (shared_) {
      place_in_shared_memory();
    } else {
      near_.place();
      far_.place();
    }
    far_.pieces[own_] = near_.pieces[own_];
  }

  [[nodiscard]] T* near(std::size_t rank) const { return near_.pieces[rank]; }
  [[nodiscard]] T* far(std::size_t rank) const { return far_.pieces[rank]; }

  /// Throw std::logic_error when called out of turn.
  void there() {
    take_turn(true);
    exchange(near_, far_);
  }
  void back() {
    take_turn(false);
    exchange(far_, near_);
  }
  /// In place of back() where nothing is handed back: gives up the far pieces, and leaves the near ones to
  /// be written.
  void release() {
    take_turn(false);
    if (shared_) meet(line_);  // others may still be reading
  }

 private:
  /// All pieces of one side. Each begins a line of the cache, so that no two ranks write to the same line.
  struct Side {
    Side(const Lengths& lengths, std::size_t own) : pieces(lengths.size()) {
      for (std::size_t r = 0; r < lengths.size(); ++r) {
        counts.push_back(r == own ? 0 : static_cast<int>(lengths[r]));
        starts.push_back(static_cast<int>(room));
        room += whole_lines<T>(lengths[r]);
      }
      if (room > std::numeric_limits<int>::max())
        throw std::invalid_argument("one rank's part of the spectrum has too many values: use more ranks");
    }
    void place() {
      memory.resize(room);
      for (std::size_t r = 0; r < pieces.size(); ++r) pieces[r] = memory.data() + starts[r];
    }
    [[nodiscard]] std::size_t bytes_sent() const {
      return sizeof(T) * std::accumulate(counts.begin(), counts.end(), std::size_t(0));
    }

    std::vector<int> counts;  ///< of what travels: none for the piece that a rank keeps
    std::vector<int> starts;
    std::size_t room = 0;
    LineVector<T> memory;  ///< unless the pieces lie in shared memory
    std::vector<T*> pieces;
  };

  static Lengths without(std::size_t own, Lengths lengths) {
    lengths[own] = 0;
    return lengths;
  }

  /// A far piece is the near piece that its rank has for this one.
  void place_in_shared_memory() {
    const auto& memory = *shared_;
    std::vector<int> starts_there(memory.size());
    check(MPI_Alltoall(near_.starts.data(), 1, MPI_INT, starts_there.data(), 1, MPI_INT, line_.get()),
          "MPI_Alltoall");
    const auto values = [&](std::size_t rank) { return reinterpret_cast<T*>(memory[rank].data()); };
    for (std::size_t r = 0; r < memory.size(); ++r) {
      near_.pieces[r] = values(own_) + near_.starts[r];
      far_.pieces[r] = values(r) + starts_there[r];
    }
  }

  void take_turn(bool to_far_side) {
    if (on_far_side_ == to_far_side) throw std::logic_error("pieces are exchanged out of turn");
    on_far_side_ = to_far_side;
  }

  void exchange(const Side& from, Side& to) {
    if (from.pieces.size() == 1) return;
    const Profile::Scope scope(profile_, Phase::kTransposition);
    if (profile_) profile_->count_messages(std::int64_t(from.pieces.size()) - 1, from.bytes_sent());
    if (shared_) {
      meet(line_);
    } else {
      send(from, to);
    }
  }

  void send(const Side& from, Side& to) const {
    check(MPI_Alltoallv(from.memory.data(), from.counts.data(), from.starts.data(), mpi_type<T>(),
                        to.memory.data(), to.counts.data(), to.starts.data(), mpi_type<T>(), line_.get()),
          "MPI_Alltoallv");
  }

  const Communicator& line_;
  Profile* profile_;
  std::size_t own_;
  Side near_, far_;
  bool on_far_side_ = false;                    ///< what is exchanged
  std::optional<std::vector<Mapping>> shared_;  ///< near pieces of every rank of the line
};

}  // namespace softwall::parallel
