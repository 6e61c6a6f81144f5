#include "solver/grid/halo.hpp"

namespace softwall::grid {

namespace {

/// Copies a box of cells into a buffer, or back; returns the number of cells.
template <bool kToBuffer>
std::size_t copy_box(Field& field, const Box& box, Real* buffer) {
  const auto cell = field.view();
  std::size_t n = 0;
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
      Real* row = &cell(box.i0, j, k);
      const int width = box.i1 - box.i0;
      if constexpr (kToBuffer) {
        std::copy(row, row + width, buffer + n);
      } else {
        std::copy(buffer + n, buffer + n + width, row);
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

}  // namespace

/// One shift of the exchange: every rank sends the box `from` of each field and receives into `to`.
struct Halo::Shift {
  const parallel::Communicator& line;
  int direction;                       ///< +1: to the next rank of the line, -1: to the previous one
  Box (*from)(const Field&, RowSpan);  ///< interior cells beside the boundary
  Box (*to)(const Field&, RowSpan);    ///< ghost cells beyond the opposite boundary
};

Halo::Halo(const parallel::Decomposition& decomposition) : decomposition_(decomposition) {}

void Halo::shift(const Shift& s, std::initializer_list<Field*> fields, RowSpan rows) {
  std::size_t total = 0;
  for (const Field* f : fields) total += cells(s.from(*f, rows));
  if (send_.size() < total) {
    send_.resize(total);
    receive_.resize(total);
  }
  std::size_t n = 0;
  for (Field* f : fields) n += copy_box<true>(*f, s.from(*f, rows), send_.data() + n);
  const int ranks = s.line.size(), rank = s.line.rank();
  const Real* arrived = send_.data();
  if (ranks > 1) {
    const int next = (rank + s.direction + ranks) % ranks, previous = (rank - s.direction + ranks) % ranks;
    const auto type = parallel::mpi_type<Real>();
    parallel::check(MPI_Sendrecv(send_.data(), static_cast<int>(total), type, next, 0, receive_.data(),
                                 static_cast<int>(total), type, previous, 0, s.line.get(), MPI_STATUS_IGNORE),
                    "MPI_Sendrecv");
    arrived = receive_.data();
  }
  n = 0;
  for (Field* f : fields) n += copy_box<false>(*f, s.to(*f, rows), const_cast<Real*>(arrived) + n);
}

void Halo::fill(std::initializer_list<Field*> fields, RowSpan rows) {
  const auto& x = decomposition_.x_line();
  const auto& z = decomposition_.z_line();
  shift({x, +1,
         [](const Field& f, RowSpan r) { return Box{f.nx() - f.ghost(), f.nx(), r.j0, r.j1, 0, f.nz()}; },
         [](const Field& f, RowSpan r) { return Box{-f.ghost(), 0, r.j0, r.j1, 0, f.nz()}; }},
        fields, rows);
  shift({x, -1, [](const Field& f, RowSpan r) { return Box{0, f.ghost(), r.j0, r.j1, 0, f.nz()}; },
         [](const Field& f, RowSpan r) { return Box{f.nx(), f.nx() + f.ghost(), r.j0, r.j1, 0, f.nz()}; }},
        fields, rows);
  // In z the ghost columns in x travel too, so that edges and corners are right.
  shift({z, +1,
         [](const Field& f, RowSpan r) {
           return Box{-f.ghost(), f.nx() + f.ghost(), r.j0, r.j1, f.nz() - f.ghost(), f.nz()};
         },
         [](const Field& f, RowSpan r) {
           return Box{-f.ghost(), f.nx() + f.ghost(), r.j0, r.j1, -f.ghost(), 0};
         }},
        fields, rows);
  shift({z, -1,
         [](const Field& f, RowSpan r) {
           return Box{-f.ghost(), f.nx() + f.ghost(), r.j0, r.j1, 0, f.ghost()};
         },
         [](const Field& f, RowSpan r) {
           return Box{-f.ghost(), f.nx() + f.ghost(), r.j0, r.j1, f.nz(), f.nz() + f.ghost()};
         }},
        fields, rows);
}

void Halo::fill(std::initializer_list<Field*> fields) {
  const Field& first = **fields.begin();
  fill(fields, {-first.ghost(), first.ny() + first.ghost()});
}

}  // namespace softwall::grid
