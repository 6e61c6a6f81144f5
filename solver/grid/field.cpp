#include "solver/grid/field.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "solver/parallel/line_memory.hpp"

namespace softwall::grid {

namespace {

constexpr std::ptrdiff_t kLine = parallel::kLineBytes / sizeof(Real);  // numbers in a line of the cache

/// Distance in memory between neighbours that are `numbers` apart at least: whole lines, but no multiple of a
/// large power of two, which would let the rows of a stencil crowd each other out of the cache.
std::ptrdiff_t spacing_of(std::ptrdiff_t numbers) {
  constexpr std::ptrdiff_t kCrowd = 8 * kLine;
  const std::ptrdiff_t length = parallel::whole_lines<Real>(numbers);
  return length % kCrowd == 0 ? length + kLine : length;
}

/// Lines left free before a field, fewer than `most`, a power of two. Large pieces of memory all begin at the
/// same place of a page, and fields read together at the same cell would share a few places of the cache: so
/// scatter them (Fibonacci hashing of the address, Knuth, The Art of Computer Programming 3, 6.4).
std::ptrdiff_t lines_before(const Real* memory, std::ptrdiff_t most) {
  const std::uint64_t page = reinterpret_cast<std::uintptr_t>(memory) / 4096;
  return static_cast<std::ptrdiff_t>((page * 0x9e3779b97f4a7c15ULL) >> 32) % most;
}

}  // namespace

void Field::Free::operator()(Real* p) const { std::free(p); }

Field::Field(const Grid& g, int ghost, Memory memory) : nx_(g.nx), ny_(g.ny), nz_(g.nz), ghost_(ghost) {
  const std::ptrdiff_t row = spacing_of(nx_ + 2 * ghost_), rows = ny_ + 2 * ghost_, planes = nz_ + 2 * ghost_;
  const bool by_plane = memory == Memory::kByPlane;
  stride_y_ = by_plane ? row : spacing_of(row * planes);
  stride_z_ = by_plane ? row * rows : row;
  const std::ptrdiff_t cells = by_plane ? stride_z_ * planes : stride_y_ * rows;
  // Fields begin as far apart as a core's own cache is long, but never by more than a small part of a field.
  std::ptrdiff_t most = 2048;
  while (most > 1 && most * kLine * 16 > cells) most /= 2;
  const auto count = static_cast<std::size_t>(cells + (most + 1) * kLine);
  if (by_plane) {
    memory_.reset(static_cast<Real*>(parallel::allocate_lines(count * sizeof(Real))));
    std::fill_n(memory_.get(), count, Real(0));
  } else {
    memory_.reset(static_cast<Real*>(parallel::allocate_untouched(count * sizeof(Real))));
  }
  // The first cell of each row begins a line; the ghost cells before it end the line of the row before.
  const std::ptrdiff_t first = ghost_ * (1 + stride_y_ + stride_z_);
  const auto address = reinterpret_cast<std::uintptr_t>(memory_.get() + first) / sizeof(Real);
  const std::ptrdiff_t to_line = (kLine - static_cast<std::ptrdiff_t>(address % kLine)) % kLine;
  offset_ = first + to_line + lines_before(memory_.get(), most) * kLine;
}

}  // namespace softwall::grid
