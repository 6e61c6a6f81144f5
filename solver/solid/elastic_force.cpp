#include "solver/solid/elastic_force.hpp"

#include <algorithm>

#include "solver/solid/fraction.hpp"

namespace softwall::solid {

namespace {

/// Stress components where they live.
struct Stress {
  Fraction phi;
  View<const Real> Bxx, Byy, Bzz, Bxy, Bxz, Byz;
  Real G;
  Real xx(int i, int j, int k) const { return G * phi.center(i, j, k) * (Bxx(i, j, k) - 1); }
  Real yy(int i, int j, int k) const { return G * phi.center(i, j, k) * (Byy(i, j, k) - 1); }
  Real zz(int i, int j, int k) const { return G * phi.center(i, j, k) * (Bzz(i, j, k) - 1); }
  Real xy(int i, int j, int k) const { return G * phi.edge_xy(i, j, k) * Bxy(i, j, k); }
  Real xz(int i, int j, int k) const { return G * phi.edge_xz(i, j, k) * Bxz(i, j, k); }
  Real yz(int i, int j, int k) const { return G * phi.edge_yz(i, j, k) * Byz(i, j, k); }
};

template <class Force>
void renew(const grid::Box& box, const Force& force, grid::Field& previous, grid::Field& sum) {
  const auto before = previous.view(), both = sum.view();
  grid::for_each_cell(box, [=](int i, int j, int k) {
    const Real now = force(i, j, k);
    both(i, j, k) = now + before(i, j, k);
    before(i, j, k) = now;
  });
}

}  // namespace

void renew_elastic_force(const Material& m, double G, const Grid& g, int first_row,
                         grid::VectorField& previous, grid::VectorField& sum) {
  const Stress s{{m.phi.view(), g.upper_share.data()},
                 m.B.xx.view(),
                 m.B.yy.view(),
                 m.B.zz.view(),
                 m.B.xy.view(),
                 m.B.xz.view(),
                 m.B.yz.view(),
                 Real(G)};
  const Real inv_dx = Real(1 / g.dx), inv_dz = Real(1 / g.dz);
  const Real *inv_dy = g.inv_dy.data(), *inv_dy_face = g.inv_dy_face.data();
  renew(
      grid::rows(g, first_row, g.ny),
      [=](int i, int j, int k) {
        return (s.xx(i, j, k) - s.xx(i - 1, j, k)) * inv_dx +
               (s.xy(i, j + 1, k) - s.xy(i, j, k)) * inv_dy[j] + (s.xz(i, j, k + 1) - s.xz(i, j, k)) * inv_dz;
      },
      previous.x, sum.x);
  renew(
      grid::rows(g, std::max(first_row, 1), g.ny),
      [=](int i, int j, int k) {
        return (s.xy(i + 1, j, k) - s.xy(i, j, k)) * inv_dx +
               (s.yy(i, j, k) - s.yy(i, j - 1, k)) * inv_dy_face[j] +
               (s.yz(i, j, k + 1) - s.yz(i, j, k)) * inv_dz;
      },
      previous.y, sum.y);
  renew(
      grid::rows(g, first_row, g.ny),
      [=](int i, int j, int k) {
        return (s.xz(i + 1, j, k) - s.xz(i, j, k)) * inv_dx +
               (s.yz(i, j + 1, k) - s.yz(i, j, k)) * inv_dy[j] + (s.zz(i, j, k) - s.zz(i, j, k - 1)) * inv_dz;
      },
      previous.z, sum.z);
}

}  // namespace softwall::solid
