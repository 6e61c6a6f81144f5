#include "solver/solid/solid.hpp"

#include <algorithm>
#include <stdexcept>

#include "solver/case/cofactor_stiffness.hpp"
#include "solver/case/elastic_law.hpp"
#include "solver/case/step_limits.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/solid/cofactors.hpp"
#include "solver/solid/transported_b/transported_b.hpp"

namespace softwall::solid {

namespace {

/// Finds the elastic force of each plane as soon as its B is ready: that of this moment, or with kMiddle that
/// of the middle of the step.
template <bool kMiddle>
class ForceOfPlanes final : public PlaneFollower {
 public:
  ForceOfPlanes(ElasticForce& force, const Material& material, int first_row)
      : force_(force), material_(material), first_row_(first_row) {}
  void plane_is_ready(int k) override {
    if constexpr (kMiddle) {
      force_.find_middle(material_, first_row_, k);
    } else {
      force_.find(material_, first_row_, k);
    }
  }

 private:
  ElasticForce& force_;
  const Material& material_;
  int first_row_;
};

}  // namespace

Solid::Solid(const SolidSpec& spec, const Grid& grid, const parallel::Decomposition& decomposition,
             grid::Halo& halo)
    : spec_(spec),
      grid_(grid),
      decomposition_(decomposition),
      formulation_(make_formulation(spec, grid, decomposition, halo)),
      force_(law_of<Real>(spec), formulation_->interface_share(), grid) {
  const InterfaceShare& share = formulation_->interface_share();
  const bool implicit = spec.stiffness == Stiffness::kImplicit;
  splits_viscosity_ = implicit && spec.viscosity_ratio > 1;
  if (spec.viscosity_ratio != 1 || !share.is_mean_by_volume())
    excess_viscosity_.emplace(spec.viscosity_ratio, formulation_->solid_from(), share, grid,
                              splits_viscosity_);
  if (implicit) row_stiffness_.emplace(spec, *formulation_, grid);
}

void Solid::start(Material& material) {
  if (material.formulation != spec_.formulation) throw std::logic_error("a material of another formulation");
  first_row_ = find_first_row(material);
  ForceOfPlanes<false> force(force_, material, first_row_);
  formulation_->make_consistent(material, first_row_, force);
}

// Rows that join the band bring old B and an old force with them. What a restart would do makes them new, so
// that a restart at this moment changes nothing.
void Solid::renew_band(Material& material) {
  if (find_first_row(material) != first_row_) start(material);
}

int Solid::find_first_row(const Material& material) const {
  const auto lowest = parallel::minimum(decomposition_.all(), formulation_->lowest_row(material));
  return std::max(0, static_cast<int>(lowest) - formulation_->margin());
}

void Solid::transport(Material& material, const grid::VectorField& velocity, const Stage& stage, double dt) {
  const std::int64_t limited_before = formulation_->limited_cells();
  if (excess_viscosity_) excess_viscosity_->renew(material, velocity, first_row_);
  const auto move = [&](PlaneFollower* follower) {
    formulation_->transport(material, velocity, stage, dt, first_row_, follower);
  };
  ForceOfPlanes<false> force(force_, material, first_row_);
  ForceOfPlanes<true> middle_force(force_, material, first_row_);
  if (!row_stiffness_) {
    force_.keep();
    move(&force);
  } else if (is_first(stage)) {
    force_.keep();
    move(&middle_force);
  } else if (is_last(stage)) {
    move(&force);
  } else {
    move(nullptr);
  }
  if (is_last(stage)) limited_cells_ += formulation_->limited_cells() - limited_before;
}

void Solid::apply_implicit_stress(const Material& material, const grid::VectorField& before,
                                  const ImplicitWeights& weights, grid::VectorField& velocity) {
  if (row_stiffness_) row_stiffness_->apply(material, before, weights, first_row_, velocity);
}

SolidInput Solid::input(const Material& material) const {
  // Implicit: the force of the middle of the step throughout.
  const auto& now = row_stiffness_ ? force_.before() : force_.now();
  SolidInput input{&material.phi, &now, &force_.before(), first_row_, spec_.viscosity_ratio};
  input.fluid_end_row = material.all_solid_from;
  if (excess_viscosity_) {
    input.excess_viscous = &excess_viscosity_->force();
    input.excess_end_row = excess_viscosity_->end_row();
    input.excess_across = excess_viscosity_->across();
  }
  if (!splits_viscosity_) {
    input.ratio_across = spec_.viscosity_ratio;
    input.interface_viscosity = interface_share().largest_factor();
  }
  return input;
}

Solid::Action Solid::action(const Material& material, const grid::VectorField& velocity) {
  const auto rows = static_cast<std::size_t>(grid_.ny);
  Action action{.elastic = &force_.now(),
                .elastic_work = std::vector<double>(rows),
                .excess_work = std::vector<double>(rows)};
  force_.add_work(material, velocity, first_row_, action.elastic_work);
  if (!excess_viscosity_) return action;
  excess_viscosity_->renew(material, velocity, first_row_);
  excess_viscosity_->add_work(material, velocity, first_row_, action.excess_work);
  action.excess = &excess_viscosity_->force();
  action.across = excess_viscosity_->across();
  action.excess_end_row = excess_viscosity_->end_row();
  return action;
}

std::vector<double> Solid::excess_shear_sums(const Material& material,
                                             const grid::VectorField& velocity) const {
  if (!excess_viscosity_) return {};
  return excess_viscosity_->shear_stress_sums(material, velocity, first_row_);
}

double Solid::elastic_limit(const Material& m) const {
  using step_limits::Deformation, step_limits::InverseSpacings;
  const auto phi = m.phi.view();
  const Cofactors C = cofactors_of(m, grid_);
  const auto law = law_of<Real>(spec_);
  const Real* inv_dy = grid_.inv_dy.data();
  const Real inv_dx = Real(1 / grid_.dx), inv_dz = Real(1 / grid_.dz);
  const auto stiffest = [&](const auto& stiffness) {
    double found = 0;  // height by height, as the fields lie in memory
    for (int j = first_row_; j < grid_.ny; ++j) {
      found = grid::max_cells(grid::rows(grid_, j, j + 1), found, [=](int i, int row, int k) {
        return phi(i, row, k) * stiffness(i, row, k, InverseSpacings<Real>{inv_dx, inv_dy[row], inv_dz});
      });
    }
    return parallel::maximum(decomposition_.all(), found);
  };
  const auto B = [=](int i, int j, int k) {
    return Deformation<Real>{C.Bxx(i, j, k), C.Byy(i, j, k), C.Bzz(i, j, k),
                             C.Bxy(i, j, k), C.Bxz(i, j, k), C.Byz(i, j, k)};
  };
  const auto found = [&](const auto& of_B, const auto& of_C) {
    if (law.is_neo_hookean())
      return stiffest([=](int i, int j, int k, const auto& inv) { return of_B(B(i, j, k), inv); });
    return stiffest([=](int i, int j, int k, const auto& inv) {
      const Deformation<Real> cofactors{C.xx(i, j, k), C.yy(i, j, k), C.zz(i, j, k),
                                        C.xy(i, j, k), C.xz(i, j, k), C.yz(i, j, k)};
      return law.mean(of_B(B(i, j, k), inv), of_C(cofactors, inv));
    });
  };
  using Tensor = const Deformation<Real>&;
  using Spacings = const InverseSpacings<Real>&;
  const double most =
      row_stiffness_ ? found([](Tensor b, Spacings inv) { return stiffness_along_rows(b, inv); },
                             [](Tensor c, Spacings inv) { return cofactor_stiffness_along_rows(c, inv); })
                     : found([](Tensor b, Spacings inv) { return stiffness(b, inv); },
                             [](Tensor c, Spacings inv) { return cofactor_stiffness(c, inv); });
  return step_limits::elastic(spec_.stiffness, law_of<double>(spec_), most);
}

Material flat_layer(const Grid& g, SolidFormulation formulation) {
  Material m(g);
  m.formulation = formulation;
  m.surface_at_rest = g.y_face[g.ny_fluid];
  if (formulation == SolidFormulation::kReferenceMap) return m;
  const auto phi = m.phi.view();
  grid::for_each_cell(grid::rows(g, g.ny_fluid, g.ny), [=](int i, int j, int k) { phi(i, j, k) = 1; });
  for (grid::Field* normal : {&m.B.xx, &m.B.yy, &m.B.zz}) {
    const auto q = normal->view();
    grid::for_each_cell(grid::rows(g, std::max(0, g.ny_fluid - 2 * TransportedB::kMargin), g.ny),
                        [=](int i, int j, int k) { q(i, j, k) = 1; });
  }
  return m;
}

}  // namespace softwall::solid
