#pragma once

#include <cmath>
#include <vector>

#include "solver/grid/halo.hpp"

namespace softwall::support {

/// A box with its grid, its share among ranks and its halo, for tests of single parts.
struct Domain {
  struct Size {
    int nx, ny, nz;
  };
  struct Lengths {
    double x = 3, z = 1.5;
  };
  Domain(MPI_Comm comm, Size n, Lengths length, const std::vector<double>& faces)
      : decomposition(comm, n.nx, n.nz),
        grid(grid::make_grid(n.nx, n.nz, length.x, length.z, faces, decomposition)),
        halo(decomposition) {}
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  const parallel::Decomposition decomposition;
  const grid::Grid grid;
  grid::Halo halo;
};

/// ny + 1 faces from 0 to height; stretching s > 0 gathers them at both walls (tanh), 0 is uniform.
inline std::vector<double> faces(int ny, double height = 2, double stretching = 0) {
  std::vector<double> y;
  for (int j = 0; j <= ny; ++j) {
    const double xi = 2.0 * j / ny - 1;
    const double eta = stretching > 0 ? std::tanh(stretching * xi) / std::tanh(stretching) : xi;
    y.push_back(height * (1 + eta) / 2);
  }
  return y;
}

inline int world_size() {
  int n = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

/// True when nx x nz columns can be shared among `ranks`.
inline bool fits(int nx, int nz, int ranks) {
  for (int pz = 1; pz <= ranks; ++pz) {
    const auto wide = [](int n, int parts) {
      return parts == 1 || n / parts >= parallel::Decomposition::kMinimumWidth;
    };
    if (ranks % pz == 0 && wide(nz, pz) && wide(nx, ranks / pz)) return true;
  }
  return false;
}

}  // namespace softwall::support
