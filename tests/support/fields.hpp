#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/fluid/walls.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/grid/field.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/pressure/projection.hpp"
#include "tests/support/domain.hpp"
#include "tests/support/noise.hpp"
#include "tests/support/worse.hpp"

/// Filling fields by formulas, and looking at them as a whole.
namespace softwall::support {

using grid::Field;
using grid::Grid;
using grid::Real;
using grid::VectorField;

/// Where in a cell a quantity lives: 0 on the low face, 0.5 at the center, in x and in z.
struct Place {
  double x = 0.5;
  bool y_face = false;
  double z = 0.5;
};
inline constexpr Place kCenter{}, kFaceX{0.0, false, 0.5}, kFaceY{0.5, true, 0.5}, kFaceZ{0.5, false, 0.0};
inline constexpr Place kEdgeXy{0.0, true, 0.5}, kEdgeXz{0.0, false, 0.0}, kEdgeYz{0.5, true, 0.0};

/// field(i,j,k) = value(global i, j, global k) in rows 0 <= j < rows.
template <class Value>
void set_by_index(Field& field, const Grid& g, int rows, const Value& value) {
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < g.nx; ++i) field(i, j, k) = value(g.x_begin + i, j, g.z_begin + k);
    }
  }
}

/// field = value(x, y, z) at the quantity's place; on y faces the upper wall too.
template <class Value>
void set_by_position(Field& field, const Grid& g, const Place& place, const Value& value) {
  set_by_index(field, g, place.y_face ? g.ny + 1 : g.ny, [&](int i, int j, int k) {
    const double y = place.y_face ? g.y_face[j] : g.y_center[j];
    return value((i + place.x) * g.dx, y, (k + place.z) * g.dz);
  });
}

/// The whole field in rows 0 <= j < rows, the same on every rank of `comm`: (nz, rows, nx), x fastest.
inline std::vector<double> global_values(const Field& field, const Grid& g, int rows,
                                         const parallel::Communicator& comm) {
  const auto nx = static_cast<std::size_t>(g.nx_global), ny = static_cast<std::size_t>(rows);
  std::vector<double> all(nx * ny * static_cast<std::size_t>(g.nz_global));
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        const auto row = static_cast<std::size_t>(g.z_begin + k) * ny + static_cast<std::size_t>(j);
        all[row * nx + static_cast<std::size_t>(g.x_begin + i)] = field(i, j, k);
      }
    }
  }
  parallel::sum(comm, all);  // every number comes from one rank, the others add zero
  return all;
}

inline double largest(const std::vector<double>& values) {
  double top = 0;
  for (const double v : values) top = worse(top, std::abs(v));
  return top;
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double top = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) {
    top = worse(top, std::abs(a[n] - b[n]));
  }
  return top;
}

/// Largest |field - value(x, y, z)| over all ranks; rows as in set_by_position.
template <class Value>
double largest_error(const Field& field, const Grid& g, const Place& place,
                     const parallel::Decomposition& decomposition, const Value& value) {
  double top = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      const double y = place.y_face ? g.y_face[j] : g.y_center[j];
      for (int i = 0; i < g.nx; ++i) {
        const double exact = value((g.x_begin + i + place.x) * g.dx, y, (g.z_begin + k + place.z) * g.dz);
        top = worse(top, std::abs(field(i, j, k) - exact));
      }
    }
  }
  return worst(decomposition.all(), top);
}

/// An owner's copy of the numbers of a field of the same shape.
inline void copy(const Field& from, Field& to) {
  const int h = from.ghost();
  for (int k = -h; k < from.nz() + h; ++k) {
    for (int j = -h; j < from.ny() + h; ++j) {
      for (int i = -h; i < from.nx() + h; ++i) to(i, j, k) = from(i, j, k);
    }
  }
}

inline void copy(const VectorField& from, VectorField& to) {
  copy(from.x, to.x);
  copy(from.y, to.y);
  copy(from.z, to.z);
}

/// Noise of size 1 in all three components, ghost cells filled.
inline VectorField random_velocity(Domain& d, int seed) {
  VectorField velocity(d.grid, 1);
  set_by_index(velocity.x, d.grid, d.grid.ny, [=](int i, int j, int k) { return noise(seed, i, j, k); });
  set_by_index(velocity.y, d.grid, d.grid.ny, [=](int i, int j, int k) { return noise(seed + 1, i, j, k); });
  set_by_index(velocity.z, d.grid, d.grid.ny, [=](int i, int j, int k) { return noise(seed + 2, i, j, k); });
  fluid::fill_ghosts(velocity, {}, d.halo);
  return velocity;
}

/// The same without divergence.
inline VectorField random_solenoidal_velocity(Domain& d, int seed) {
  VectorField velocity = random_velocity(d, seed);
  Field pressure(d.grid, 1);
  pressure::Projection projection(d.grid, d.decomposition, d.halo);
  for (int twice = 0; twice < 2; ++twice) {  // the second pass polishes round-off
    projection.project(velocity, pressure, kRungeKutta3[0], 1.0);
    fluid::fill_ghosts(velocity, {}, d.halo);
  }
  return velocity;
}

}  // namespace softwall::support
