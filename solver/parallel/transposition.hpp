#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include "solver/parallel/decomposition.hpp"
#include "solver/parallel/line_memory.hpp"
#include "solver/parallel/piece_exchange.hpp"

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
/// either side of an exchange. On the way:
///   pack() of every block, to_modes(), then load() and store() of every mode, to_planes(), unpack().
template <class T>
class Transposition {
 public:
  /// Number of z that lie side by side in memory: as many as fill a line of the cache.
  static constexpr int kPlanes = kLineBytes / sizeof(T);

  /// `modes` and `z_total` are shared among the ranks of `line`; every rank has all `rows` in y.
  Transposition(const Communicator& line, int modes, int rows, int z_total, Profile* profile = nullptr,
                Way way = Way::kBest)
      : rows_(rows),
        rank_(static_cast<std::size_t>(line.rank())),
        modes_(shares(modes, line.size())),
        z_(shares(z_total, line.size())),
        pieces_(line, volumes(modes_, {own_z()}), volumes({own_modes()}, z_), profile, way) {}

  [[nodiscard]] Range own_modes() const { return modes_[rank_]; }

  /// `rows`: value (k, j, mode) of the block at [((k - k0) * (j1 - j0) + j - j0) * stride + mode].
  void pack(const RowBlock& b, const T* rows, std::ptrdiff_t stride) {
    turn(b, rows, stride, [](T* turned, const T* straight) { std::memcpy(turned, straight, sizeof(T)); });
  }
  void unpack(const RowBlock& b, T* rows, std::ptrdiff_t stride) {
    turn(b, rows, stride, [](const T* turned, T* straight) { std::memcpy(straight, turned, sizeof(T)); });
  }

  void to_modes() { pieces_.there(); }
  void to_planes() { pieces_.back(); }
  /// In place of to_planes() where nothing goes back.
  void leave_modes() { pieces_.release(); }

  /// Values of one of this rank's modes, counted from 0: (j, k) at plane[j * stride + k], all z.
  void load(int mode, T* plane, std::ptrdiff_t stride) {
    each_piece(mode, plane, stride, [](T* piece, T* row, int n) { std::copy(piece, piece + n, row); });
  }
  void store(int mode, T* plane, std::ptrdiff_t stride) {
    each_piece(mode, plane, stride, [](T* piece, T* row, int n) { std::copy(row, row + n, piece); });
  }

 private:
  static constexpr int kRowsAhead = 2;

  [[nodiscard]] Range own_z() const { return z_[rank_]; }
  /// Distance between the modes of a piece that is `z` long: an odd number of lines, so that the modes do
  /// not all fall on one place of the cache.
  [[nodiscard]] std::ptrdiff_t mode_length(int z) const {
    const int values = whole_lines<T>(rows_ * z);
    return values / kPlanes % 2 == 0 ? values + kPlanes : values;
  }
  /// Volumes of the pieces for every share of the modes, or of z, the other being one share.
  [[nodiscard]] std::vector<std::size_t> volumes(const std::vector<Range>& modes,
                                                 const std::vector<Range>& z) const {
    std::vector<std::size_t> all;
    for (const Range& m : modes) {
      for (const Range& k : z)
        all.push_back(static_cast<std::size_t>(m.size()) * static_cast<std::size_t>(mode_length(k.size())));
    }
    return all;
  }

  /// Pieces have the layout (mode, y, z) on both sides. Tiles of kPlanes modes and planes read and write
  /// whole lines of the cache. These lie so far apart that only we know which comes next: they are fetched
  /// kRowsAhead rows before their turn.
  template <class Value, class Copy>
  void turn(const RowBlock& b, Value* rows, std::ptrdiff_t stride, const Copy& copy) {
    const std::ptrdiff_t plane = b.rows() * stride, length = mode_length(own_z().size());
    constexpr int kWritesPieces = std::is_const_v<Value> ? 1 : 0;
    const auto tile = [&](T* turned, std::ptrdiff_t ahead, Value* straight, int modes, int planes) {
      for (int m = 0; m < modes; ++m) {
        __builtin_prefetch(turned + m * length + ahead, kWritesPieces);
        for (int q = 0; q < planes; ++q) copy(turned + m * length + q, straight + q * plane + m);
      }
    };
    for (std::size_t r = 0; r < modes_.size(); ++r) {
      const Range part = modes_[r];
      for (int j = b.j0; j < b.j1; ++j) {
        T* turned = pieces_.near(r) + std::ptrdiff_t(j) * own_z().size() + b.k0;
        const std::ptrdiff_t ahead = std::ptrdiff_t(std::min(kRowsAhead, rows_ - 1 - j)) * own_z().size();
        Value* straight = rows + (j - b.j0) * stride + part.begin;
        int left = part.size();
        if (b.planes() == kPlanes) {
          for (; left >= kPlanes; left -= kPlanes, turned += kPlanes * length, straight += kPlanes)
            tile(turned, ahead, straight, kPlanes, kPlanes);
        }
        tile(turned, ahead, straight, left, b.planes());
      }
    }
  }

  template <class CopyRow>
  void each_piece(int mode, T* plane, std::ptrdiff_t stride, const CopyRow& copy_row) {
    for (std::size_t r = 0; r < z_.size(); ++r) {
      const int width = z_[r].size();
      T* piece = pieces_.far(r) + mode * mode_length(width);
      T* row = plane + z_[r].begin;
      for (int j = 0; j < rows_; ++j, piece += width, row += stride) copy_row(piece, row, width);
    }
  }

  int rows_;
  std::size_t rank_;
  std::vector<Range> modes_, z_;
  PieceExchange<T> pieces_;
};

}  // namespace softwall::parallel
