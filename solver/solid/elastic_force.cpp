#include "solver/solid/elastic_force.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "solver/grid/cell_loop.hpp"
#include "solver/grid/stage.hpp"
#include "solver/solid/cofactors.hpp"
#include "solver/solid/fraction.hpp"
#include "solver/solid/stress_work.hpp"

namespace softwall::solid {

namespace {

/// Stress components where they live, where all is solid.
struct StressOfSolid {
  static constexpr bool kAcrossRowsOnly = false;
  View<const Real> Bxx, Byy, Bzz, Bxy, Bxz, Byz;
  ElasticLaw<Real> law;
  Real xx(int i, int j, int k) const { return law.normal_stress(Bxx(i, j, k)); }
  Real yy(int i, int j, int k) const { return law.normal_stress(Byy(i, j, k)); }
  Real zz(int i, int j, int k) const { return law.normal_stress(Bzz(i, j, k)); }
  Real xy(int i, int j, int k) const { return law.shear_stress(Bxy(i, j, k)); }
  Real xz(int i, int j, int k) const { return law.shear_stress(Bxz(i, j, k)); }
  Real yz(int i, int j, int k) const { return law.shear_stress(Byz(i, j, k)); }
};

/// The same of a law that needs the cofactors of B, too.
struct StressWithCofactors {
  static constexpr bool kAcrossRowsOnly = false;
  Cofactors C;
  ElasticLaw<Real> law;
  Real xx(int i, int j, int k) const { return law.normal_stress(C.Bxx(i, j, k), C.xx(i, j, k)); }
  Real yy(int i, int j, int k) const { return law.normal_stress(C.Byy(i, j, k), C.yy(i, j, k)); }
  Real zz(int i, int j, int k) const { return law.normal_stress(C.Bzz(i, j, k), C.zz(i, j, k)); }
  Real xy(int i, int j, int k) const { return law.shear_stress(C.Bxy(i, j, k), C.xy(i, j, k)); }
  Real xz(int i, int j, int k) const { return law.shear_stress(C.Bxz(i, j, k), C.xz(i, j, k)); }
  Real yz(int i, int j, int k) const { return law.shear_stress(C.Byz(i, j, k), C.yz(i, j, k)); }
};

/// Stress components anywhere: the solid's, times its share.
template <class OfSolid>
struct Stress {
  static constexpr bool kAcrossRowsOnly = false;
  OfSolid solid;
  Fraction phi;
  InterfaceShareView share;
  Real xx(int i, int j, int k) const { return phi.center(i, j, k) * solid.xx(i, j, k); }
  Real yy(int i, int j, int k) const { return phi.center(i, j, k) * solid.yy(i, j, k); }
  Real zz(int i, int j, int k) const { return phi.center(i, j, k) * solid.zz(i, j, k); }
  Real xy(int i, int j, int k) const {
    return share_of_solid(phi.edge_xy(i, j, k), share.xy(i, k)) * solid.xy(i, j, k);
  }
  Real xz(int i, int j, int k) const { return phi.edge_xz(i, j, k) * solid.xz(i, j, k); }
  Real yz(int i, int j, int k) const {
    return share_of_solid(phi.edge_yz(i, j, k), share.yz(i, k)) * solid.yz(i, j, k);
  }
};

}  // namespace

ElasticForce::ElasticForce(ElasticLaw<Real> law, const InterfaceShare& share, const Grid& grid)
    : law_(law), share_(share), grid_(grid), divergence_(grid), now_(grid, 0), before_(grid, 0) {}

void ElasticForce::keep() { std::swap(now_, before_); }

/// Calls visit(stress, j0, j1) for the rows that fluid and solid share, and for those that are all solid.
template <class Visit>
void ElasticForce::with_stress(const Material& m, int first_row, const Visit& visit) const {
  const int above = std::max(first_row, m.solid_edges_from(grid_.ny));
  const auto with = [&](const auto& solid) {
    visit(Stress<std::decay_t<decltype(solid)>>{solid, fraction_of(m, share_, grid_), share_.view()},
          first_row, above);
    visit(solid, above, grid_.ny);
  };
  if (law_.is_neo_hookean()) {
    with(StressOfSolid{.Bxx = m.B.xx.view(),
                       .Byy = m.B.yy.view(),
                       .Bzz = m.B.zz.view(),
                       .Bxy = m.B.xy.view(),
                       .Bxz = m.B.xz.view(),
                       .Byz = m.B.yz.view(),
                       .law = law_});
  } else {
    with(StressWithCofactors{cofactors_of(m, grid_), law_});
  }
}

void ElasticForce::find(const Material& m, int first_row, int k) {
  with_stress(m, first_row,
              [&](const auto& stress, int j0, int j1) { divergence_.find(stress, j0, j1, k, now_); });
}

void ElasticForce::add_work(const Material& m, const grid::VectorField& velocity, int first_row,
                            std::vector<double>& work) const {
  with_stress(m, first_row, [&](const auto& stress, int j0, int j1) {
    add_stress_work(stress, velocity, grid_, j0, j1, work);
  });
}

void ElasticForce::find_middle(const Material& m, int first_row, int k) {
  constexpr Real kShare = Real(0.5 / kRungeKutta3.front().beta);
  find(m, first_row, k);
  for (auto component : {&grid::VectorField::x, &grid::VectorField::y, &grid::VectorField::z}) {
    const auto after = (now_.*component).view(), middle = (before_.*component).view();
    grid::for_each_cell({0, grid_.nx, first_row, grid_.ny, k, k + 1}, [=](int i, int j, int plane) {
      middle(i, j, plane) += kShare * (after(i, j, plane) - middle(i, j, plane));
    });
  }
}

}  // namespace softwall::solid
