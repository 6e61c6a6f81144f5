#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "solver/parallel/mpi.hpp"

/// Reductions whose result depends on the number of ranks but never on the order of arrival:
/// the partial values are gathered and combined in rank order. Restart is bitwise because of this.
namespace softwall::parallel {

/// Element-wise sum over ranks, in place, with room for the values of all ranks.
inline void sum_at_once(const Communicator& comm, std::span<double> values) {
  const int ranks = comm.size();
  const auto n = static_cast<int>(values.size());
  std::array<double, 512> room{};  // reductions of a time step are small and need no allocation
  std::vector<double> more;
  const std::size_t count = values.size() * static_cast<std::size_t>(ranks);
  if (count > room.size()) more.resize(count);
  const std::span parts(count > room.size() ? more.data() : room.data(), count);
  check(MPI_Allgather(values.data(), n, MPI_DOUBLE, parts.data(), n, MPI_DOUBLE, comm.get()),
        "MPI_Allgather");
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t i = 0; i < parts.size(); ++i) values[i % values.size()] += parts[i];
}

/// Element-wise sum over ranks, in place: piece by piece, so that however many values and ranks there are,
/// a rank needs 8 MiB for it.
inline void sum(const Communicator& comm, std::span<double> values) {
  if (comm.size() == 1) return;
  constexpr std::size_t kRoom = std::size_t{1} << 20;
  const std::size_t piece = std::max<std::size_t>(kRoom / static_cast<std::size_t>(comm.size()), 1);
  for (std::size_t begin = 0; begin < values.size(); begin += piece)
    sum_at_once(comm, values.subspan(begin, std::min(piece, values.size() - begin)));
}

[[nodiscard]] inline double sum(const Communicator& comm, double value) {
  sum(comm, std::span(&value, 1));
  return value;
}

[[nodiscard]] inline double maximum(const Communicator& comm, double value) {
  double result = 0.0;
  check(MPI_Allreduce(&value, &result, 1, MPI_DOUBLE, MPI_MAX, comm.get()), "MPI_Allreduce");
  return result;
}

[[nodiscard]] inline double minimum(const Communicator& comm, double value) { return -maximum(comm, -value); }

/// True everywhere when true anywhere.
[[nodiscard]] inline bool any(const Communicator& comm, bool value) {
  return maximum(comm, value ? 1.0 : 0.0) > 0.5;
}

}  // namespace softwall::parallel
