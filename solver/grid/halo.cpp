#include "solver/grid/halo.hpp"

#include <algorithm>
#include <type_traits>

namespace softwall::grid {

namespace {

/// Copies a box of cells into a buffer, or out of one that is constant; returns the number of cells.
template <class Value>
std::size_t copy_box(Field& field, const Box& box, Value* buffer) {
  const auto cell = field.view();
  std::size_t n = 0;
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
      Real* row = &cell(box.i0, j, k);
      const int width = box.i1 - box.i0;
      if constexpr (std::is_const_v<Value>) {
        std::copy(buffer + n, buffer + n + width, row);
      } else {
        std::copy(row, row + width, buffer + n);
      }
      n += static_cast<std::size_t>(width);
    }
  }
  return n;
}

std::size_t cells(const Box& b) {
  return static_cast<std::size_t>(b.i1 - b.i0) * static_cast<std::size_t>(b.j1 - b.j0) *
         static_cast<std::size_t>(b.k1 - b.k0);
}

/// What travels to fill one side: the cells `from` of each field, on every rank, to the ghost cells `to` of
/// its neighbour in `direction` along a line of ranks.
struct Shift {
  Box from, to;
  int direction;
};

/// In z the ghost columns in x travel too, so that edges and corners are right.
Shift shift_to(Side side, const Field& f, RowSpan r) {
  const int ghost = f.ghost(), nx = f.nx(), nz = f.nz();
  const auto x = [&](int i0, int i1) { return Box{i0, i1, r.j0, r.j1, 0, nz}; };
  const auto z = [&](int k0, int k1) { return Box{-ghost, nx + ghost, r.j0, r.j1, k0, k1}; };
  switch (side) {
    case Side::kLowX:
      return {x(nx - ghost, nx), x(-ghost, 0), +1};
    case Side::kHighX:
      return {x(0, ghost), x(nx, nx + ghost), -1};
    case Side::kLowZ:
      return {z(nz - ghost, nz), z(-ghost, 0), +1};
    default:
      return {z(0, ghost), z(nz, nz + ghost), -1};
  }
}

bool in_x(Side side) { return side == Side::kLowX || side == Side::kHighX; }

/// A direction that is all on this rank, however narrow: each ghost cell is a copy of an interior one.
void wrap(Side side, Field& f, RowSpan rows) {
  const auto cell = f.view();
  const Box to = shift_to(side, f, rows).to;
  const auto wrapped = [](int index, int n) { return (index % n + n) % n; };
  if (!in_x(side)) {
    for (int k = to.k0; k < to.k1; ++k) {
      const int from = wrapped(k, f.nz());
      for (int j = to.j0; j < to.j1; ++j)
        std::copy(&cell(to.i0, j, from), &cell(to.i1, j, from), &cell(to.i0, j, k));
    }
    return;
  }
  for (int i = to.i0; i < to.i1; ++i) {
    const int from = wrapped(i, f.nx());
    for (int k = to.k0; k < to.k1; ++k) {
      for (int j = to.j0; j < to.j1; ++j) cell(i, j, k) = cell(from, j, k);
    }
  }
}

/// Both sides in x at once: the ghost cells at the end of a row and those before the next share a line of the
/// cache (field.cpp).
void wrap_in_x(Field& f, RowSpan rows) {
  if (f.ghost() > f.nx()) {
    wrap(Side::kLowX, f, rows);
    wrap(Side::kHighX, f, rows);
    return;
  }
  const auto cell = f.view();
  const int nx = f.nx(), ghost = f.ghost();
  for (int k = 0; k < f.nz(); ++k) {
    for (int j = rows.j0; j < rows.j1; ++j) wrap_row(&cell(0, j, k), nx, ghost);
  }
}

/// The ghost columns beyond a wall become copies of the column at it.
void repeat_column(Side side, Field& f, RowSpan rows) {
  const auto cell = f.view();
  const Box to = shift_to(side, f, rows).to;
  const int at_wall = side == Side::kLowX ? 0 : f.nx() - 1;
  for_each_cell(to, [=](int i, int j, int k) { cell(i, j, k) = cell(at_wall, j, k); });
}

}  // namespace

Halo::Halo(const parallel::Decomposition& decomposition, bool walls_in_x, parallel::Profile* profile)
    : decomposition_(decomposition),
      walls_in_x_(walls_in_x),
      profile_(profile),
      shift_in_x_(decomposition.x_line()),
      shift_in_z_(decomposition.z_line()) {}

const parallel::Communicator& Halo::line_of(Side side) const {
  return in_x(side) ? decomposition_.x_line() : decomposition_.z_line();
}

bool Halo::at_wall(Side side) const {
  const auto& line = decomposition_.x_line();
  return walls_in_x_ && ((side == Side::kLowX && line.rank() == 0) ||
                         (side == Side::kHighX && line.rank() == line.size() - 1));
}

void Halo::fill_side(Side side, std::initializer_list<Field*> fields, RowSpan rows) {
  const parallel::Profile::Scope scope(profile_, parallel::Phase::kHalo);
  if (line_of(side).size() > 1) {
    exchange(side, fields, rows);
  } else {
    for (Field* f : fields) wrap(side, *f, rows);
  }
  if (!at_wall(side)) return;
  for (Field* f : fields) repeat_column(side, *f, rows);
}

/// Exchanges ghost cells with the neighbours along the line, which has more than one rank, each with at least
/// as many columns as ghost layers.
void Halo::exchange(Side side, std::initializer_list<Field*> fields, RowSpan rows) {
  std::size_t total = 0;
  for (const Field* f : fields) total += cells(shift_to(side, *f, rows).from);
  auto& line_shift = in_x(side) ? shift_in_x_ : shift_in_z_;
  Real* const outgoing = line_shift.outgoing(total);
  std::size_t n = 0;
  for (Field* f : fields) n += copy_box(*f, shift_to(side, *f, rows).from, outgoing + n);
  const Real* const incoming = line_shift.shift(shift_to(side, **fields.begin(), rows).direction);
  if (profile_) profile_->count_messages(1, total * sizeof(Real));
  n = 0;
  for (Field* f : fields) n += copy_box(*f, shift_to(side, *f, rows).to, incoming + n);
}

void Halo::fill_in_x(std::initializer_list<Field*> fields, RowSpan rows) {
  if (wraps_in_x()) {
    const parallel::Profile::Scope scope(profile_, parallel::Phase::kHalo);
    for (Field* f : fields) wrap_in_x(*f, rows);
  } else {
    for (const Side side : {Side::kLowX, Side::kHighX}) fill_side(side, fields, rows);
  }
}

void Halo::fill_in_z(std::initializer_list<Field*> fields, RowSpan rows) {
  for (const Side side : {Side::kLowZ, Side::kHighZ}) fill_side(side, fields, rows);
}

void Halo::fill(std::initializer_list<Field*> fields) {
  const Field& first = **fields.begin();
  fill(fields, {-first.ghost(), first.ny() + first.ghost()});
}

}  // namespace softwall::grid
