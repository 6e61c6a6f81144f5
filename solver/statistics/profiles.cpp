#include "solver/statistics/profiles.hpp"

#include <array>

#include "solver/case/elastic_law.hpp"
#include "solver/fluid/momentum.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/solid/cofactors.hpp"
#include "solver/solid/fraction.hpp"

namespace softwall::statistics {

namespace {

using analysis::Location;
using grid::Grid;
using grid::Real;

constexpr std::array<ProfileKind, kProfileCount> kProfileKinds = {{
    {"u", Location::kCenter, "", ""},
    {"v", Location::kCenter, "", ""},
    {"w", Location::kCenter, "", ""},
    {"uu", Location::kCenter, "", ""},
    {"vv", Location::kCenter, "", ""},
    {"ww", Location::kCenter, "", ""},
    {"p", Location::kCenter, "", ""},
    {"pp", Location::kCenter, "", ""},
    {"uv", Location::kFace, "", ""},
    {"viscous_stress", Location::kFace, "", ""},
    {"v_face", Location::kFace, "U_b", "mean wall-normal velocity on the faces where it lives"},
    {"vv_face", Location::kFace, "U_b^2", "raw second moment <v v> on the faces where v lives"},
    {"phi", Location::kCenter, "", ""},
    {"fluid_u", Location::kCenter, "U_b", "streamwise flow of the fluid, <(1 - phi) u>"},
    {"elastic_stress", Location::kFace, "", ""},
    {"elastic_xx", Location::kCenter, "rho U_b^2",
     "mean elastic normal stress <phi G B_xx> (Mooney-Rivlin: <phi (c1 B_xx - c2 C_xx)>)"},
    {"elastic_yy", Location::kCenter, "rho U_b^2",
     "mean elastic normal stress <phi G B_yy> (Mooney-Rivlin: <phi (c1 B_yy - c2 C_yy)>)"},
    {"elastic_zz", Location::kCenter, "rho U_b^2",
     "mean elastic normal stress <phi G B_zz> (Mooney-Rivlin: <phi (c1 B_zz - c2 C_zz)>)"},
}};

/// u, u u, w, w w, p, p p of one line of cells in x, added to row j.
void add_center_line(const time::State& s, int nx, int j, int k, PlaneMeans& sums) {
  const auto u = s.velocity.x.view(), w = s.velocity.z.view(), p = s.pressure.view();
  double u1 = 0, u2 = 0, w1 = 0, w2 = 0, p1 = 0, p2 = 0;
#pragma omp simd reduction(+ : u1, u2, w1, w2, p1, p2)
  for (int i = 0; i < nx; ++i) {
    const double a = u(i, j, k), b = w(i, j, k), c = p(i, j, k);
    u1 += a;
    u2 += a * a;
    w1 += b;
    w2 += b * b;
    p1 += c;
    p2 += c * c;
  }
  sums(kU, j) += u1;
  sums(kUu, j) += u2;
  sums(kW, j) += w1;
  sums(kWw, j) += w2;
  sums(kP, j) += p1;
  sums(kPp, j) += p2;
}

/// v, v v on faces; u v and the viscous stress on xy edges.
void add_face_line(const fluid::MomentumInput& m, int nx, int j, int k, PlaneMeans& sums) {
  double v1 = 0, v2 = 0, uv = 0, viscous = 0;
#pragma omp simd reduction(+ : v1, v2, uv, viscous)
  for (int i = 0; i < nx; ++i) {
    const Real v = m.v(i, j, k);
    const Real product = (m.u(i, j, k) + m.u(i, j - 1, k)) / 2 * ((v + m.v(i - 1, j, k)) / 2);
    v1 += v;
    v2 += double(v) * v;
    uv += product;
    viscous += fluid::flux_xy(m, i, j, k) + product;
  }
  sums(kVFace, j) += v1;
  sums(kVvFace, j) += v2;
  sums(kUv, j) += uv;
  sums(kViscousStress, j) += viscous;
}

/// phi, flow of the fluid (weighted as fluid/forcing.hpp does) and elastic normal stresses.
void add_solid_center_line(const time::State& s, double G, int nx, int j, int k, PlaneMeans& sums) {
  const auto u = s.velocity.x.view(), phi = s.material.phi.view(), xx = s.material.B.xx.view(),
             yy = s.material.B.yy.view(), zz = s.material.B.zz.view();
  double fraction = 0, flow = 0, stress_x = 0, stress_y = 0, stress_z = 0;
#pragma omp simd reduction(+ : fraction, flow, stress_x, stress_y, stress_z)
  for (int i = 0; i < nx; ++i) {
    const double f = phi(i, j, k);
    fraction += f;
    flow += (1 - (f + phi(i - 1, j, k)) / 2) * u(i, j, k);
    stress_x += f * xx(i, j, k);
    stress_y += f * yy(i, j, k);
    stress_z += f * zz(i, j, k);
  }
  sums(kPhi, j) += fraction;
  sums(kFluidU, j) += flow;
  sums(kElasticXx, j) += G * stress_x;
  sums(kElasticYy, j) += G * stress_y;
  sums(kElasticZz, j) += G * stress_z;
}

/// What the second constant of a Mooney-Rivlin solid changes of these normal stresses: B becomes B - m (B +
/// C).
void add_second_constant(const time::State& s, const ElasticLaw<double>& law, const Grid& g, int j, int k,
                         PlaneMeans& sums) {
  const auto phi = s.material.phi.view();
  const solid::Cofactors C = solid::cofactors_of(s.material, g);
  double stress_x = 0, stress_y = 0, stress_z = 0;
#pragma omp simd reduction(+ : stress_x, stress_y, stress_z)
  for (int i = 0; i < g.nx; ++i) {
    const double f = phi(i, j, k);
    stress_x += f * (C.Bxx(i, j, k) + C.xx(i, j, k));
    stress_y += f * (C.Byy(i, j, k) + C.yy(i, j, k));
    stress_z += f * (C.Bzz(i, j, k) + C.zz(i, j, k));
  }
  const double c2 = law.G * law.mooney_share;
  sums(kElasticXx, j) -= c2 * stress_x;
  sums(kElasticYy, j) -= c2 * stress_y;
  sums(kElasticZz, j) -= c2 * stress_z;
}

void add_solid_face_line(const time::State& s, const Grid& g, const ElasticLaw<double>& law,
                         const solid::InterfaceShare& share, int j, int k, PlaneMeans& sums) {
  const auto xy = s.material.B.xy.view();
  const auto shared = share.view();
  const auto share_of_edge = [=, phi = solid::fraction_of(s.material, share, g)](int i) {
    return solid::share_of_solid(phi.edge_xy(i, j, k), shared.xy(i, k));
  };
  double stress = 0;
  if (law.is_neo_hookean()) {
#pragma omp simd reduction(+ : stress)
    for (int i = 0; i < g.nx; ++i) stress += share_of_edge(i) * xy(i, j, k);
  } else {
    const solid::Cofactors C = solid::cofactors_of(s.material, g);
    const Real m = Real(law.mooney_share);
#pragma omp simd reduction(+ : stress)
    for (int i = 0; i < g.nx; ++i)
      stress += share_of_edge(i) * (xy(i, j, k) - m * (xy(i, j, k) + C.xy(i, j, k)));
  }
  sums(kElasticStress, j) += law.G * stress;
}

/// Sums over this rank's part of every plane: one sweep through the fields, line by line.
PlaneMeans local_sums(const time::State& s, const time::Setup& setup) {
  const Grid& g = setup.grid;
  const auto m = fluid::momentum_input(s.velocity, g, setup.viscosity);
  const int solid_row = setup.solid ? setup.solid->first_row() : g.ny + 1;
  const auto law = setup.physics.solid ? law_of<double>(*setup.physics.solid) : ElasticLaw<double>{0};
  PlaneMeans sums(s.elastic, g.ny);
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j <= g.ny; ++j) {
      if (j < g.ny) add_center_line(s, g.nx, j, k, sums);
      add_face_line(m, g.nx, j, k, sums);
      if (j < solid_row) continue;
      if (j < g.ny) add_solid_center_line(s, law.G, g.nx, j, k, sums);
      if (j < g.ny && !law.is_neo_hookean()) add_second_constant(s, law, g, j, k, sums);
      add_solid_face_line(s, g, law, setup.solid->interface_share(), j, k, sums);
    }
  }
  if (s.elastic) {
    const auto excess = setup.solid->excess_shear_sums(s.material, s.velocity);
    for (std::size_t j = 0; j < excess.size(); ++j)
      sums(kViscousStress, static_cast<int>(j)) += setup.viscosity * excess[j];
    // Below the band all is fluid.
    for (int j = 0; j < solid_row; ++j) sums(kFluidU, j) = sums(kU, j);
  }
  return sums;
}

}  // namespace

std::span<const ProfileKind> profile_kinds(bool elastic) {
  return std::span(kProfileKinds).first(elastic ? std::size_t(kProfileCount) : std::size_t(kPhi));
}

PlaneMeans plane_means(const time::State& s, const time::Setup& setup) {
  const Grid& g = setup.grid;
  PlaneMeans means = local_sums(s, setup);
  parallel::sum(setup.decomposition.all(), means.values());
  const double columns = double(g.nx_global) * g.nz_global;
  for (double& value : means.values()) value /= columns;
  for (int j = 0; j < g.ny; ++j) {
    means(kV, j) = (means(kVFace, j) + means(kVFace, j + 1)) / 2;
    means(kVv, j) = (means(kVvFace, j) + means(kVvFace, j + 1)) / 2;
  }
  return means;
}

}  // namespace softwall::statistics
