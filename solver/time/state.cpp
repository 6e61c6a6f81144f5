#include "solver/time/state.hpp"

#include <cmath>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/solid/solid.hpp"

namespace softwall::time {

std::vector<NamedField> fields_of(State& s) {
  const int ny = s.pressure.ny();
  std::vector<NamedField> fields{
      {"u", "streamwise velocity on low-x faces, U_b", &s.velocity.x, ny},
      {"v", "wall-normal velocity on low-y faces, U_b", &s.velocity.y, ny + 1},
      {"w", "spanwise velocity on low-z faces, U_b", &s.velocity.z, ny},
      {"p", "pressure at centers, rho U_b^2", &s.pressure, ny},
  };
  if (!s.elastic) return fields;
  auto& m = s.material;
  if (m.formulation == SolidFormulation::kReferenceMap) {
    fields.insert(fields.end(),
                  {
                      {"d_x", "streamwise displacement on low-x faces, h", &m.displacement.x, ny},
                      {"d_y", "wall-normal displacement on low-y faces, h", &m.displacement.y, ny + 1},
                      {"d_z", "spanwise displacement on low-z faces, h", &m.displacement.z, ny},
                  });
    return fields;
  }
  fields.insert(fields.end(), {
                                  {"phi", "solid fraction at centers", &m.phi, ny},
                                  {"B_xx", "left Cauchy-Green tensor at centers", &m.B.xx, ny},
                                  {"B_yy", "left Cauchy-Green tensor at centers", &m.B.yy, ny},
                                  {"B_zz", "left Cauchy-Green tensor at centers", &m.B.zz, ny},
                                  {"B_xy", "left Cauchy-Green tensor on low-x low-y edges", &m.B.xy, ny + 1},
                                  {"B_xz", "left Cauchy-Green tensor on low-x low-z edges", &m.B.xz, ny},
                                  {"B_yz", "left Cauchy-Green tensor on low-y low-z edges", &m.B.yz, ny + 1},
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
  const auto total = [&](const grid::Field& f) {
    const auto q = f.view();
    return grid::sum_cells({0, f.nx(), 0, f.ny(), 0, f.nz()},
                           [=](int i, int j, int k) { return q(i, j, k); });
  };
  double sum = total(s.velocity.x) + total(s.velocity.y) + total(s.velocity.z) + total(s.pressure);
  if (s.elastic) {
    const auto& B = s.material.B;
    const auto& d = s.material.displacement;
    sum += total(s.material.phi) + total(B.xx) + total(B.yy) + total(B.zz) + total(B.xy) + total(B.xz) +
           total(B.yz) + total(d.x) + total(d.y) + total(d.z);
  }
  return !parallel::any(decomposition.all(), !std::isfinite(sum));
}

}  // namespace softwall::time
