#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "solver/parallel/decomposition.hpp"
#include "solver/parallel/profile.hpp"

/// Pencil to pencil: makes one axis whole and splits another instead, within one line of ranks.
namespace softwall::parallel {

enum Axis : std::size_t { kZ = 0, kY = 1, kX = 2 };

/// Extents of a dense array, x fastest.
using Extents = std::array<int, 3>;  // {z, y, x}

/// Redistributes arrays between two layouts of one line of ranks:
///   `before`: axis `scattered` whole, axis `gathered` split;  `after`: the other way round.
template <class T>
class Transfer {
 public:
  /// `before` are this rank's extents with `scattered` whole; `gathered_total` is the whole extent of the
  /// other axis.
  Transfer(const Communicator& line, Extents before, Axis scattered, Axis gathered, int gathered_total,
           Profile* profile = nullptr)
      : line_(line),
        profile_(profile),
        before_(before),
        after_(before),
        scattered_(scattered),
        gathered_(gathered) {
    const int ranks = line.size(), rank = line.rank();
    scattered_parts_ = shares(before[scattered], ranks);
    gathered_parts_ = shares(gathered_total, ranks);
    after_[scattered] = scattered_parts_[static_cast<std::size_t>(rank)].size();
    after_[gathered] = gathered_total;
    if (ranks > 1) {
      out_.resize(volume(before_));
      in_.resize(volume(after_));
    }
  }

  [[nodiscard]] bool trivial() const { return scattered_parts_.size() == 1; }
  [[nodiscard]] const Extents& before() const { return before_; }
  [[nodiscard]] const Extents& after() const { return after_; }
  [[nodiscard]] static std::size_t volume(const Extents& e) {
    return static_cast<std::size_t>(e[0]) * static_cast<std::size_t>(e[1]) * static_cast<std::size_t>(e[2]);
  }

  /// before -> after. With one rank in the line both layouts are the same: nothing is to be called.
  void forward(const T* source, T* target) {
    exchange({source, before_, scattered_, scattered_parts_, out_},
             {target, after_, gathered_, gathered_parts_, in_});
  }
  /// after -> before.
  void backward(const T* source, T* target) {
    exchange({source, after_, gathered_, gathered_parts_, in_},
             {target, before_, scattered_, scattered_parts_, out_});
  }

 private:
  /// One end of an exchange: an array, the axis along which it is cut into a part for each rank, a buffer.
  template <class Pointer>
  struct End {
    Pointer array;
    const Extents& extents;
    Axis axis;
    const std::vector<Range>& parts;
    std::vector<T>& buffer;
  };

  void exchange(const End<const T*>& from, const End<T*>& to) {
    const Profile::Scope scope(profile_, Phase::kTransposition);
    std::vector<int>&send_counts = counts_[0], &send_starts = counts_[1], &receive_counts = counts_[2],
    &receive_starts = counts_[3];
    layout(from.extents, from.axis, from.parts, send_counts, send_starts);
    layout(to.extents, to.axis, to.parts, receive_counts, receive_starts);
    const auto own = static_cast<std::size_t>(send_counts[static_cast<std::size_t>(line_.rank())]);
    if (profile_) profile_->count_messages(line_.size() - 1, (volume(from.extents) - own) * sizeof(T));
    copy_parts(from, [](const T* cell, T* packed, int n) { std::copy(cell, cell + n, packed); });
    check(MPI_Alltoallv(from.buffer.data(), send_counts.data(), send_starts.data(), mpi_type<T>(),
                        to.buffer.data(), receive_counts.data(), receive_starts.data(), mpi_type<T>(),
                        line_.get()),
          "MPI_Alltoallv");
    copy_parts(to, [](T* cell, const T* packed, int n) { std::copy(packed, packed + n, cell); });
  }

  static void layout(Extents extents, Axis axis, const std::vector<Range>& parts, std::vector<int>& counts,
                     std::vector<int>& starts) {
    counts.resize(parts.size());
    starts.resize(parts.size());
    int start = 0;
    for (std::size_t r = 0; r < parts.size(); ++r) {
      extents[axis] = parts[r].size();
      counts[r] = static_cast<int>(volume(extents));
      starts[r] = start;
      start += counts[r];
    }
  }

  template <class EndType, class CopyRow>
  static void copy_parts(const EndType& end, const CopyRow& copy_row) {
    T* packed = end.buffer.data();
    for (const Range& part : end.parts) {
      std::array<Range, 3> box{Range{0, end.extents[0]}, Range{0, end.extents[1]}, Range{0, end.extents[2]}};
      box[end.axis] = part;
      for (int z = box[kZ].begin; z < box[kZ].end; ++z) {
        for (int y = box[kY].begin; y < box[kY].end; ++y) {
          const auto row = (static_cast<std::size_t>(z) * static_cast<std::size_t>(end.extents[kY]) +
                            static_cast<std::size_t>(y)) *
                           static_cast<std::size_t>(end.extents[kX]);
          copy_row(end.array + row + box[kX].begin, packed, box[kX].size());
          packed += box[kX].size();
        }
      }
    }
  }

  const Communicator& line_;
  Profile* profile_;
  Extents before_, after_;
  Axis scattered_, gathered_;
  std::vector<Range> scattered_parts_, gathered_parts_;
  std::vector<T> out_, in_;
  std::array<std::vector<int>, 4> counts_;
};

}  // namespace softwall::parallel
