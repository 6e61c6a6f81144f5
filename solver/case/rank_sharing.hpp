#pragma once

#include <string>

/// Which numbers of ranks can share a grid: known to the solver, which shares it, and to the manager, which
/// says so before anything is started.
namespace softwall {

/// The narrowest part of a direction that is shared: the transport of the solid reads three neighbours on
/// either side. A direction that is whole on every rank may be narrower.
inline constexpr int kNarrowestPart = 3;

/// Whether n columns can be shared among so many parts.
[[nodiscard]] inline bool can_be_shared(int n, int parts) {
  return parts == 1 || n / parts >= kNarrowestPart;
}

/// Why no layout of nx x nz columns feeds so many ranks; empty when one does.
[[nodiscard]] std::string sharing_problem(int ranks, int nx, int nz);

}  // namespace softwall
