#pragma once

#include "tests/support/fields.hpp"

namespace softwall::support {

/// field = value(x, y, z) in ghost cells too, wherever row arrays reach: for kernels away from boundaries.
template <class Value>
void set_everywhere(Field& field, const Grid& g, const Place& place, const Value& value) {
  const int h = field.ghost();
  for (int k = -h; k < g.nz + h; ++k) {
    for (int j = -h; j < g.ny + h; ++j) {
      for (int i = -h; i < g.nx + h; ++i) {
        const double y = place.y_face ? g.y_face[j] : g.y_center[j];
        field(i, j, k) = value((g.x_begin + i + place.x) * g.dx, y, (g.z_begin + k + place.z) * g.dz);
      }
    }
  }
}

/// A constant velocity gradient: gradient[a][b] = du_a / dx_b.
struct LinearFlow {
  double gradient[3][3];
  double at(int a, double x, double y, double z) const {
    return gradient[a][0] * x + gradient[a][1] * y + gradient[a][2] * z;
  }
  VectorField on(const Grid& g, int ghost = 1) const {
    VectorField velocity(g, ghost);
    set_everywhere(velocity.x, g, kFaceX, [this](double x, double y, double z) { return at(0, x, y, z); });
    set_everywhere(velocity.y, g, kFaceY, [this](double x, double y, double z) { return at(1, x, y, z); });
    set_everywhere(velocity.z, g, kFaceZ, [this](double x, double y, double z) { return at(2, x, y, z); });
    return velocity;
  }
};

/// Nine different numbers, trace zero.
inline constexpr LinearFlow kGeneralFlow{{{0.7, -1.1, 0.4}, {0.3, -1.2, 0.9}, {-0.6, 0.2, 0.5}}};

}  // namespace softwall::support
