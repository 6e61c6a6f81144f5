#pragma once

#include <numbers>

#include "tests/support/fields.hpp"

/// Vortices that turn a solid for a while, slow to a halt, and turn it back to where it was.
namespace softwall::support {

/// psi = sin^2(pi y) sin(2 pi periods) / 12 on y face j, `periods` along x or z: it vanishes with its
/// gradient on the walls y = 0, 1.
inline double vortex_stream_function(const Grid& g, int j, double periods) {
  return std::pow(std::sin(std::numbers::pi * g.y_face[j]), 2) * std::sin(2 * std::numbers::pi * periods) /
         12;
}

/// The velocity of the stream function on the edges along z, u = dpsi/dy, v = -dpsi/dx: discretely
/// solenoidal.
inline VectorField vortex_in_xy(Domain& d) {
  const auto& g = d.grid;
  const auto psi = [&](int i, int j) { return vortex_stream_function(g, j, double(i) / g.nx_global); };
  VectorField unit(g, 1);
  set_by_index(unit.x, g, g.ny, [&](int i, int j, int) { return (psi(i, j + 1) - psi(i, j)) / g.dy[j]; });
  set_by_index(unit.y, g, g.ny, [&](int i, int j, int) { return -(psi(i + 1, j) - psi(i, j)) / g.dx; });
  fluid::fill_ghosts(unit, {}, d.halo);
  return unit;
}

/// The same with z in the place of x.
inline VectorField vortex_in_yz(Domain& d) {
  const auto& g = d.grid;
  const auto psi = [&](int k, int j) { return vortex_stream_function(g, j, double(k) / g.nz_global); };
  VectorField unit(g, 1);
  set_by_index(unit.z, g, g.ny, [&](int, int j, int k) { return (psi(k, j + 1) - psi(k, j)) / g.dy[j]; });
  set_by_index(unit.y, g, g.ny, [&](int, int j, int k) { return -(psi(k + 1, j) - psi(k, j)) / g.dz; });
  fluid::fill_ghosts(unit, {}, d.halo);
  return unit;
}

/// A steady velocity times cos(pi t): at t = 1 everything is back.
class ReversingVelocity {
 public:
  /// Refers to `unit` for as long as it lives. Ghost cells filled.
  ReversingVelocity(const VectorField& unit, const Grid& grid) : unit_(unit), now_(grid, 1) {}

  /// Valid until the next call.
  const VectorField& at(double t) {
    const double scale = std::cos(std::numbers::pi * t);
    copy(unit_, now_);
    for (Field* f : {&now_.x, &now_.y, &now_.z}) {
      for (int k = -1; k <= f->nz(); ++k) {
        for (int j = -1; j <= f->ny(); ++j) {
          for (int i = -1; i <= f->nx(); ++i) (*f)(i, j, k) *= scale;
        }
      }
    }
    return now_;
  }

 private:
  const VectorField& unit_;
  VectorField now_;
};

}  // namespace softwall::support
