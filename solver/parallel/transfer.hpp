#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "solver/parallel/decomposition.hpp"
#include "solver/parallel/piece_exchange.hpp"

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
           Profile* profile = nullptr, Way way = Way::kBest)
      : profile_(profile),
        rank_(static_cast<std::size_t>(line.rank())),
        before_(before),
        after_(before),
        scattered_(scattered),
        gathered_(gathered),
        scattered_parts_(shares(before[scattered], line.size())),
        gathered_parts_(shares(gathered_total, line.size())) {
    after_[scattered] = own_part().size();
    after_[gathered] = gathered_total;
    if (trivial()) return;
    pieces_.emplace(line, volumes(before_, scattered_, scattered_parts_),
                    volumes(after_, gathered_, gathered_parts_), profile, way);
  }

  [[nodiscard]] bool trivial() const { return scattered_parts_.size() == 1; }
  /// The part of the scattered axis that is this rank's after forward().
  [[nodiscard]] Range own_part() const { return scattered_parts_[rank_]; }
  [[nodiscard]] const Extents& before() const { return before_; }
  [[nodiscard]] const Extents& after() const { return after_; }
  [[nodiscard]] static std::size_t volume(const Extents& e) {
    return static_cast<std::size_t>(e[0]) * static_cast<std::size_t>(e[1]) * static_cast<std::size_t>(e[2]);
  }

  /// before -> after, and then after -> before. With one rank in the line both layouts are the same: neither
  /// is to be called.
  void forward(const T* source, T* target) {
    const Profile::Scope scope(profile_, Phase::kTransposition);
    for (std::size_t r = 0; r < scattered_parts_.size(); ++r)
      pack(source, {before_, scattered_, scattered_parts_[r]}, pieces_->near(r));
    pieces_->there();
    for (std::size_t r = 0; r < gathered_parts_.size(); ++r)
      unpack(pieces_->far(r), {after_, gathered_, gathered_parts_[r]}, target);
  }
  void backward(const T* source, T* target) {
    const Profile::Scope scope(profile_, Phase::kTransposition);
    for (std::size_t r = 0; r < gathered_parts_.size(); ++r)
      pack(source, {after_, gathered_, gathered_parts_[r]}, pieces_->far(r));
    pieces_->back();
    for (std::size_t r = 0; r < scattered_parts_.size(); ++r)
      unpack(pieces_->near(r), {before_, scattered_, scattered_parts_[r]}, target);
  }
  /// In place of backward() where nothing goes back.
  void release() { pieces_->release(); }

 private:
  /// An array's cells of which one index is in `range`.
  struct Part {
    const Extents& whole;
    Axis axis;
    Range range;
  };

  static std::vector<std::size_t> volumes(Extents extents, Axis axis, const std::vector<Range>& parts) {
    std::vector<std::size_t> all;
    for (const Range& part : parts) {
      extents[axis] = part.size();
      all.push_back(volume(extents));
    }
    return all;
  }

  static void pack(const T* array, const Part& part, T* piece) {
    each_row(part, [&](std::size_t first, int n) { piece = std::copy_n(array + first, n, piece); });
  }
  static void unpack(const T* piece, const Part& part, T* array) {
    each_row(part, [&](std::size_t first, int n) {
      std::copy_n(piece, n, array + first);
      piece += n;
    });
  }

  /// Calls `copy(index of its first cell, length)` for each row of a part.
  template <class Copy>
  static void each_row(const Part& part, const Copy& copy) {
    const auto& whole = part.whole;
    std::array<Range, 3> box{Range{0, whole[0]}, Range{0, whole[1]}, Range{0, whole[2]}};
    box[part.axis] = part.range;
    for (int z = box[kZ].begin; z < box[kZ].end; ++z) {
      for (int y = box[kY].begin; y < box[kY].end; ++y) {
        const auto row =
            static_cast<std::size_t>(z) * static_cast<std::size_t>(whole[kY]) + static_cast<std::size_t>(y);
        copy(row * static_cast<std::size_t>(whole[kX]) + static_cast<std::size_t>(box[kX].begin),
             box[kX].size());
      }
    }
  }

  Profile* profile_;
  std::size_t rank_;
  Extents before_, after_;
  Axis scattered_, gathered_;
  std::vector<Range> scattered_parts_, gathered_parts_;
  std::optional<PieceExchange<T>> pieces_;  ///< unless there is but one rank
};

}  // namespace softwall::parallel
