#include "solver/solid/elastic_force.hpp"

#include <algorithm>

#include "solver/solid/fraction.hpp"
#include "solver/solid/stress_divergence.hpp"

namespace softwall::solid {

namespace {

/// Stress components where they live.
struct Stress {
  Fraction phi;
  View<const Real> Bxx, Byy, Bzz, Bxy, Bxz, Byz;
  Real G;
  InterfaceShare share;
  Real xx(int i, int j, int k) const { return G * phi.center(i, j, k) * (Bxx(i, j, k) - 1); }
  Real yy(int i, int j, int k) const { return G * phi.center(i, j, k) * (Byy(i, j, k) - 1); }
  Real zz(int i, int j, int k) const { return G * phi.center(i, j, k) * (Bzz(i, j, k) - 1); }
  Real xy(int i, int j, int k) const { return G * share.solid(phi.edge_xy(i, j, k)) * Bxy(i, j, k); }
  Real xz(int i, int j, int k) const { return G * phi.edge_xz(i, j, k) * Bxz(i, j, k); }
  Real yz(int i, int j, int k) const { return G * share.solid(phi.edge_yz(i, j, k)) * Byz(i, j, k); }
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

void renew_elastic_force(const Material& m, double G, const InterfaceShare& share, const Grid& g,
                         int first_row, grid::VectorField& previous, grid::VectorField& sum) {
  const StressDivergence<Stress> force({{m.phi.view(), g.upper_share.data()},
                                        m.B.xx.view(),
                                        m.B.yy.view(),
                                        m.B.zz.view(),
                                        m.B.xy.view(),
                                        m.B.xz.view(),
                                        m.B.yz.view(),
                                        Real(G),
                                        share},
                                       g);
  const auto centers = grid::rows(g, first_row, g.ny), faces = grid::rows(g, std::max(first_row, 1), g.ny);
  renew(
      centers, [=](int i, int j, int k) { return force.x(i, j, k); }, previous.x, sum.x);
  renew(
      faces, [=](int i, int j, int k) { return force.y(i, j, k); }, previous.y, sum.y);
  renew(
      centers, [=](int i, int j, int k) { return force.z(i, j, k); }, previous.z, sum.z);
}

}  // namespace softwall::solid
