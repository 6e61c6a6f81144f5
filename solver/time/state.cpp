#include "solver/time/state.hpp"

#include <cmath>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/solid/solid.hpp"

namespace softwall::time {

namespace {

/// visit(name, description, field, rows) for each field of the state, in the order of a checkpoint.
template <class AnyState, class Visit>
void for_each_field(AnyState& s, const Visit& visit) {
  const int ny = s.pressure.ny();
  visit("u", "streamwise velocity on low-x faces, U_b", s.velocity.x, ny);
  visit("v", "wall-normal velocity on low-y faces, U_b", s.velocity.y, ny + 1);
  visit("w", "spanwise velocity on low-z faces, U_b", s.velocity.z, ny);
  visit("p", "pressure at centers, rho U_b^2", s.pressure, ny);
  if (!s.elastic) return;
  auto& m = s.material;
  if (m.formulation == SolidFormulation::kReferenceMap) {
    visit("d_x", "streamwise displacement on low-x faces, h", m.displacement.x, ny);
    visit("d_y", "wall-normal displacement on low-y faces, h", m.displacement.y, ny + 1);
    visit("d_z", "spanwise displacement on low-z faces, h", m.displacement.z, ny);
    return;
  }
  visit("phi", "solid fraction at centers", m.phi, ny);
  visit("B_xx", "left Cauchy-Green tensor at centers", m.B.xx, ny);
  visit("B_yy", "left Cauchy-Green tensor at centers", m.B.yy, ny);
  visit("B_zz", "left Cauchy-Green tensor at centers", m.B.zz, ny);
  visit("B_xy", "left Cauchy-Green tensor on low-x low-y edges", m.B.xy, ny + 1);
  visit("B_xz", "left Cauchy-Green tensor on low-x low-z edges", m.B.xz, ny);
  visit("B_yz", "left Cauchy-Green tensor on low-y low-z edges", m.B.yz, ny + 1);
}

}  // namespace

std::vector<NamedField> fields_of(State& s) {
  std::vector<NamedField> fields;
  for_each_field(s, [&](const char* name, const char* description, grid::Field& field, int rows) {
    fields.push_back({name, description, &field, rows});
  });
  return fields;
}

State state_at_rest(const grid::Grid& grid, std::optional<SolidFormulation> formulation) {
  State s;
  s.velocity = grid::VectorField(grid, 1, grid::Memory::kByPlane);
  s.pressure = grid::Field(grid, 1, grid::Memory::kByPlane);
  s.elastic = formulation.has_value();
  if (formulation) s.material = solid::flat_layer(grid, *formulation);
  return s;
}

bool is_finite(const State& s, const parallel::Decomposition& decomposition) {
  // A sum is finite only if every term is; one pass, no branch per cell.
  double sum = 0;
  for_each_field(s, [&](const char*, const char*, const grid::Field& field, int rows) {
    const auto q = field.view();
    sum += grid::sum_cells({0, field.nx(), 0, rows, 0, field.nz()},
                           [=](int i, int j, int k) { return q(i, j, k); });
  });
  return !parallel::any(decomposition.all(), !std::isfinite(sum));
}

}  // namespace softwall::time
