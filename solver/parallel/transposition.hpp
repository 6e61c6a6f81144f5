#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "solver/parallel/decomposition.hpp"

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
  static constexpr int kPlanes = sizeof(T) < 64 ? 64 / sizeof(T) : 1;

  /// `modes` and `z_total` are shared among the ranks of `line`; every rank has all `rows` in y.
  Transposition(const Communicator& line, int modes, int rows, int z_total)
      : line_(line),
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
    turn(
        b,
        [&](T* turned, std::ptrdiff_t flat, int planes, std::ptrdiff_t plane) {
          for (int q = 0; q < planes; ++q) turned[q] = rows[flat + q * plane];
        },
        stride);
  }
  void unpack(const RowBlock& b, T* rows, std::ptrdiff_t stride) {
    turn(
        b,
        [&](const T* turned, std::ptrdiff_t flat, int planes, std::ptrdiff_t plane) {
          for (int q = 0; q < planes; ++q) rows[flat + q * plane] = turned[q];
        },
        stride);
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
  };

  [[nodiscard]] int own_z() const { return z_[rank_].size(); }
  [[nodiscard]] std::size_t volume(int modes, int z) const {
    return static_cast<std::size_t>(modes) * static_cast<std::size_t>(rows_) * static_cast<std::size_t>(z);
  }

  /// Pieces have the layout (mode, y, z) on both sides.
  template <class Copy>
  void turn(const RowBlock& b, const Copy& copy, std::ptrdiff_t stride) {
    const std::ptrdiff_t plane = b.rows() * stride;
    for (std::size_t r = 0; r < modes_.size(); ++r) {
      T* const piece = sent_.data() + send_.starts[r];
      for (int mode = modes_[r].begin; mode < modes_[r].end; ++mode) {
        T* to = piece + (std::ptrdiff_t(mode - modes_[r].begin) * rows_ + b.j0) * own_z() + b.k0;
        std::ptrdiff_t flat = mode;
        if (b.planes() == kPlanes) {  // a whole line of the cache at once
          for (int j = b.j0; j < b.j1; ++j, to += own_z(), flat += stride) copy(to, flat, kPlanes, plane);
        } else {
          for (int j = b.j0; j < b.j1; ++j, to += own_z(), flat += stride) copy(to, flat, b.planes(), plane);
        }
      }
    }
  }

  template <class CopyRow>
  void each_piece(int mode, T* plane, std::ptrdiff_t stride, const CopyRow& copy_row) {
    for (std::size_t r = 0; r < z_.size(); ++r) {
      const int width = z_[r].size();
      T* piece = (r == rank_ ? sent_.data() + send_.starts[r] : received_.data() + receive_.starts[r]) +
                 std::ptrdiff_t(mode) * rows_ * width;
      T* row = plane + z_[r].begin;
      for (int j = 0; j < rows_; ++j, piece += width, row += stride) copy_row(piece, row, width);
    }
  }

  void exchange(const std::vector<T>& from, const Counts& out, std::vector<T>& to, const Counts& in) {
    if (modes_.size() == 1) return;
    check(MPI_Alltoallv(from.data(), out.counts.data(), out.starts.data(), mpi_type<T>(), to.data(),
                        in.counts.data(), in.starts.data(), mpi_type<T>(), line_.get()),
          "MPI_Alltoallv");
  }

  const Communicator& line_;
  int rows_;
  std::size_t rank_;
  std::vector<Range> modes_, z_;
  Counts send_, receive_;
  std::vector<T> sent_;      ///< a piece for each rank, this one's own too
  std::vector<T> received_;  ///< a piece from each other rank
};

}  // namespace softwall::parallel
