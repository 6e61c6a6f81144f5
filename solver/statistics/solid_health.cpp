#include "solver/statistics/solid_health.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/solid/reference_map/strain.hpp"
#include "solver/solid/transported_b/limiter.hpp"
#include "solver/statistics/closed_box/body.hpp"
#include "solver/statistics/interface_height.hpp"

namespace softwall::statistics {

namespace {

using solid::Material;

/// Smallest eigenvalue and largest |det - 1| found so far.
struct Extremes {
  double min_eigenvalue = std::numeric_limits<double>::infinity();
  double max_det_error = 0;
};

/// One cell. The eigenvalue is computed only when Sylvester's criterion says that it beats the smallest so
/// far: a few products instead of a cubic equation for nearly all cells.
void visit(const solid::SymmetricTensor& B, bool counts, Extremes& extremes) {
  if (counts) extremes.max_det_error = std::max(extremes.max_det_error, std::abs(B.determinant() - 1));
  if (B.shifted(-extremes.min_eigenvalue).positive_definite()) return;
  extremes.min_eigenvalue = std::min(extremes.min_eigenvalue, solid::min_eigenvalue(B));
}

/// Extremes of a solid that carries a reference map. They compare the determinant of F F^T, because that of B
/// is 1 by construction, and leave out cells without any solid, because what stands there was only
/// extrapolated. Nearly every row is done with its first loop, which has no branches.
Extremes extremes_of_map(const Material& m, const grid::Grid& g, const grid::Box& box, double threshold) {
  const auto phi = m.phi.view();
  const auto strain = solid::reference_map::strain_of(m.displacement, g);
  Extremes extremes;
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
      const double least = extremes.min_eigenvalue;
      double max_det_error = 0;
      int beaten = 0;
#pragma omp simd reduction(max : max_det_error) reduction(+ : beaten)
      for (int i = box.i0; i < box.i1; ++i) {
        const auto map = strain.center(i, j, k);
        const double determinant = map.determinant();
        const double error = phi(i, j, k) >= threshold ? std::abs(1 / (determinant * determinant) - 1) : 0;
        max_det_error = error > max_det_error ? error : max_det_error;
        const auto B = solid::reference_map::left_cauchy_green(map);
        beaten += phi(i, j, k) > 0 && !B.shifted(-least).positive_definite() ? 1 : 0;
      }
      extremes.max_det_error = std::max(extremes.max_det_error, max_det_error);
      for (int i = box.i0; beaten > 0 && i < box.i1; ++i) {
        if (phi(i, j, k) > 0)
          visit(solid::reference_map::left_cauchy_green(strain.center(i, j, k)), false, extremes);
      }
    }
  }
  return extremes;
}

Extremes extremes_of(const Material& m, const grid::Grid& g, const grid::Box& box, double threshold) {
  if (m.formulation == SolidFormulation::kReferenceMap) return extremes_of_map(m, g, box, threshold);
  const auto phi = m.phi.view();
  Extremes extremes;
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
      for (int i = box.i0; i < box.i1; ++i) {
        visit(solid::tensor_at_center(m.B, i, j, k), phi(i, j, k) >= threshold, extremes);
      }
    }
  }
  return extremes;
}

/// Sum of phi times the weight of its row. All rows, also those below the band: what little phi may be left
/// there belongs to the sum.
template <class WeightOfRow>
double sum_of(const grid::Field& field, const grid::Grid& g, const parallel::Decomposition& decomposition,
              const WeightOfRow& weight) {
  const auto phi = field.view();
  const double here =
      grid::sum_cells(grid::all_cells(g), [=](int i, int j, int k) { return phi(i, j, k) * weight(j); });
  return parallel::sum(decomposition.all(), here);
}

double width_of(const Material& m, const time::Setup& setup) {
  const auto& g = setup.grid;
  if (is_closed_box(setup.physics.flow)) return body_of(m.phi, g, setup.decomposition).width_cells;
  return interface_width(m.phi, g, setup.decomposition);
}

}  // namespace

SolidHealth solid_health(const time::State& state, const time::Setup& setup) {
  if (!setup.solid) return {};
  const auto& g = setup.grid;
  const auto& all = setup.decomposition.all();
  const Material& m = state.material;
  const Extremes here =
      extremes_of(m, g, grid::rows(g, setup.solid->first_row(), g.ny), setup.physics.solid->threshold);
  const double* dy = g.dy.exact();
  const double volume_over_area = sum_of(m.phi, g, setup.decomposition, [dy](int j) { return dy[j]; });
  return {parallel::minimum(all, here.min_eigenvalue), parallel::maximum(all, here.max_det_error),
          width_of(m, setup), g.dx * g.dz * volume_over_area};
}

double solid_cells(const time::State& state, const time::Setup& setup) {
  return sum_of(state.material.phi, setup.grid, setup.decomposition, [](int) { return 1.0; });
}

}  // namespace softwall::statistics
