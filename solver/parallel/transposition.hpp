#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "solver/parallel/decomposition.hpp"
#include "solver/parallel/line_memory.hpp"
#include "solver/parallel/profile.hpp"

/// Turns a spectrum shared in z: from planes of one z, all modes in x, to planes of one mode, all z; and
/// back.
namespace softwall::parallel {

/// A few rows of a few planes on the side of the cells: z in [k0, k1), y in [j0, j1).
struct RowBlock {
  int k0 = 0, k1 = 0, j0 = 0, j1 = 0;
  [[nodiscard]] int planes() const { return k1 - k0; }
  [[nodiscard]] int rows() const { return j1 - j0; }
};

/// The axes turn while values are packed, block by block in the cache, so each travels through memory once on
/// either side of a message, and what stays on a rank is not copied again. On the way:
///   pack() of every block, to_modes(), then load() and store() of every mode, to_planes(), unpack().
template <class T>
class Transposition {
 public:
  /// So many z lie beside each other in memory: a line of the cache.
  static constexpr int kPlanes = kLineBytes / sizeof(T);

  /// `modes` and `z_total` are shared among the ranks of `line`; every rank has all `rows` in y.
  Transposition(const Communicator& line, int modes, int rows, int z_total, Profile* profile = nullptr)
      : line_(line),
        profile_(profile),
        rows_(rows),
        rank_(static_cast<std::size_t>(line.rank())),
        modes_(shares(modes, line.size())),
        z_(shares(z_total, line.size())) {
    std::size_t sent = 0, received = 0;
    for (std::size_t r = 0; r < modes_.size(); ++r) {
      const auto out = volume(modes_[r].size(), own_z()), in = volume(own_modes().size(), z_[r].size());
      const bool stays = r == rank_;
      send_.add(stays ? 0 : out, sent);
      receive_.add(stays ? 0 : in, received);
      sent += out;
      received += stays ? 0 : in;
    }
    sent_.resize(sent);
    received_.resize(received);
  }

  [[nodiscard]] Range own_modes() const { return modes_[rank_]; }

  /// `rows`: value (k, j, mode) of the block at [((k - k0) * (j1 - j0) + j - j0) * stride + mode].
  void pack(const RowBlock& b, const T* rows, std::ptrdiff_t stride) {
    turn(b, rows, stride, [](T* turned, const T* straight) { std::memcpy(turned, straight, sizeof(T)); });
  }
  void unpack(const RowBlock& b, T* rows, std::ptrdiff_t stride) {
    turn(b, rows, stride, [](const T* turned, T* straight) { std::memcpy(straight, turned, sizeof(T)); });
  }

  void to_modes() { exchange(sent_, send_, received_, receive_); }
  void to_planes() { exchange(received_, receive_, sent_, send_); }

  /// Values of one of this rank's modes, counted from 0: (j, k) at plane[j * stride + k], all z.
  void load(int mode, T* plane, std::ptrdiff_t stride) {
    each_piece(mode, plane, stride, [](T* piece, T* row, int n) { std::copy(piece, piece + n, row); });
  }
  void store(int mode, T* plane, std::ptrdiff_t stride) {
    each_piece(mode, plane, stride, [](T* piece, T* row, int n) { std::copy(row, row + n, piece); });
  }

 private:
  struct Counts {
    std::vector<int> counts, starts;
    void add(std::size_t count, std::size_t start) {
      counts.push_back(static_cast<int>(count));
      starts.push_back(static_cast<int>(start));
    }
    [[nodiscard]] std::size_t total() const {
      return static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), std::int64_t(0)));
    }
  };

  [[nodiscard]] int own_z() const { return z_[rank_].size(); }
  /// Distance between the modes of a piece that is `z` long: an odd number of lines, lest all of them share
  /// one place of the cache.
  [[nodiscard]] std::ptrdiff_t mode_length(int z) const {
    const int values = whole_lines<T>(rows_ * z);
    return values / kPlanes % 2 == 0 ? values + kPlanes : values;
  }
  [[nodiscard]] std::size_t volume(int modes, int z) const {
    return static_cast<std::size_t>(modes) * static_cast<std::size_t>(mode_length(z));
  }

  /// Pieces have the layout (mode, y, z) on both sides. Tiles of kPlanes modes and planes read and write
  /// whole lines of the cache.
  template <class Value, class Copy>
  void turn(const RowBlock& b, Value* rows, std::ptrdiff_t stride, const Copy& copy) {
    const std::ptrdiff_t plane = b.rows() * stride, length = mode_length(own_z());
    const auto tile = [&](T* turned, Value* straight, int modes, int planes) {
      for (int m = 0; m < modes; ++m) {
        for (int q = 0; q < planes; ++q) copy(turned + m * length + q, straight + q * plane + m);
      }
    };
    for (std::size_t r = 0; r < modes_.size(); ++r) {
      const Range part = modes_[r];
      for (int j = b.j0; j < b.j1; ++j) {
        T* turned = sent_.data() + send_.starts[r] + std::ptrdiff_t(j) * own_z() + b.k0;
        Value* straight = rows + (j - b.j0) * stride + part.begin;
        int left = part.size();
        if (b.planes() == kPlanes) {
          for (; left >= kPlanes; left -= kPlanes, turned += kPlanes * length, straight += kPlanes)
            tile(turned, straight, kPlanes, kPlanes);
        }
        tile(turned, straight, left, b.planes());
      }
    }
  }

  template <class CopyRow>
  void each_piece(int mode, T* plane, std::ptrdiff_t stride, const CopyRow& copy_row) {
    for (std::size_t r = 0; r < z_.size(); ++r) {
      const int width = z_[r].size();
      T* piece = (r == rank_ ? sent_.data() + send_.starts[r] : received_.data() + receive_.starts[r]) +
                 mode * mode_length(width);
      T* row = plane + z_[r].begin;
      for (int j = 0; j < rows_; ++j, piece += width, row += stride) copy_row(piece, row, width);
    }
  }

  void exchange(const LineVector<T>& from, const Counts& out, LineVector<T>& to, const Counts& in) {
    if (modes_.size() == 1) return;
    const Profile::Scope scope(profile_, Phase::kTransposition);
    if (profile_) profile_->count_messages(line_.size() - 1, out.total() * sizeof(T));
    check(MPI_Alltoallv(from.data(), out.counts.data(), out.starts.data(), mpi_type<T>(), to.data(),
                        in.counts.data(), in.starts.data(), mpi_type<T>(), line_.get()),
          "MPI_Alltoallv");
  }

  const Communicator& line_;
  Profile* profile_;
  int rows_;
  std::size_t rank_;
  std::vector<Range> modes_, z_;
  Counts send_, receive_;
  LineVector<T> sent_;      ///< a piece for each rank, this one's own too
  LineVector<T> received_;  ///< a piece from each other rank
};

}  // namespace softwall::parallel
