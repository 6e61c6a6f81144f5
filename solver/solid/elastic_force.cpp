#include "solver/solid/elastic_force.hpp"

#include <utility>

#include "solver/solid/fraction.hpp"

namespace softwall::solid {

namespace {

/// Stress components where they live.
struct Stress {
  static constexpr bool kAcrossRowsOnly = false;
  Fraction phi;
  View<const Real> Bxx, Byy, Bzz, Bxy, Bxz, Byz;
  Real G;
  InterfaceShareView share;
  Real xx(int i, int j, int k) const { return G * phi.center(i, j, k) * (Bxx(i, j, k) - 1); }
  Real yy(int i, int j, int k) const { return G * phi.center(i, j, k) * (Byy(i, j, k) - 1); }
  Real zz(int i, int j, int k) const { return G * phi.center(i, j, k) * (Bzz(i, j, k) - 1); }
  Real xy(int i, int j, int k) const {
    return G * share_of_solid(phi.edge_xy(i, j, k), share.xy(i, k)) * Bxy(i, j, k);
  }
  Real xz(int i, int j, int k) const { return G * phi.edge_xz(i, j, k) * Bxz(i, j, k); }
  Real yz(int i, int j, int k) const {
    return G * share_of_solid(phi.edge_yz(i, j, k), share.yz(i, k)) * Byz(i, j, k);
  }
};

}  // namespace

ElasticForce::ElasticForce(double G, const InterfaceShare& share, const Grid& grid)
    : G_(Real(G)), share_(share), grid_(grid), divergence_(grid), now_(grid, 0), before_(grid, 0) {}

void ElasticForce::keep() { std::swap(now_, before_); }

void ElasticForce::find(const Material& m, int first_row, int k) {
  const Stress stress{{m.phi.view(), grid_.upper_share.data()},
                      m.B.xx.view(),
                      m.B.yy.view(),
                      m.B.zz.view(),
                      m.B.xy.view(),
                      m.B.xz.view(),
                      m.B.yz.view(),
                      G_,
                      share_.view()};
  divergence_.find(stress, first_row, grid_.ny, k, now_);
}

}  // namespace softwall::solid
