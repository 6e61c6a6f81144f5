#include "solver/pressure/projection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"

namespace softwall::pressure {

namespace {

double sum_of_row(const Real* row, int n) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (int i = 0; i < n; ++i) sum += row[i];
  return sum;
}

/// div(u*) / duration goes to the Poisson solver, psi comes back; the sums of u* over the cells of each row
/// are taken on the way. wraps: ghost cells in x are copied while their row is in the cache.
class DivergenceAndPsi final : public PoissonRows {
 public:
  DivergenceAndPsi(grid::VectorField& velocity, double duration, const Grid& g, grid::Field& psi,
                   double* row_sums, bool wraps)
      : own_u_(velocity.x.view()),
        divergence_(velocity, g),
        psi_(psi.view()),
        inv_duration_(Real(1 / duration)),
        inv_dy_(g.inv_dy.data()),
        row_sums_(row_sums),
        nx_(g.nx),
        wraps_(wraps) {
    std::fill_n(row_sums, g.ny, 0.0);
  }

  void give_right_side(int j, int k, Real* row) override {
    if (wraps_) own_u_(nx_, j, k) = own_u_(0, j, k);
    const Divergence divergence = divergence_;  // a copy, which what the loop writes cannot change
    const Real inv_duration = inv_duration_, inv_dy = inv_dy_[j];
    const int nx = nx_;
#pragma omp simd
    for (int i = 0; i < nx; ++i) row[i] = inv_duration * divergence.at(i, j, k, inv_dy);
    row_sums_[j] += sum_of_row(&divergence.u(0, j, k), nx);
  }

  void take_solution(int j, int k, const Real* row) override {
    std::copy(row, row + nx_, &psi_(0, j, k));
    if (wraps_) psi_(-1, j, k) = row[nx_ - 1];
  }

 private:
  grid::View<Real> own_u_;
  Divergence divergence_;
  grid::View<Real> psi_;
  Real inv_duration_;
  const Real* inv_dy_;
  double* row_sums_;
  int nx_;
  bool wraps_;
};

}  // namespace

Projection::Projection(const Grid& grid, const parallel::Decomposition& decomposition, grid::Halo& halo,
                       parallel::Profile* profile)
    : grid_(grid),
      halo_(halo),
      profile_(profile),
      poisson_(grid, decomposition, profile),
      psi_(grid, 1, grid::Memory::kByPlane),
      row_sums_(static_cast<std::size_t>(grid.ny)) {}

/// The divergence of a cell needs the velocity on its high faces; the wall-normal one is whole on every rank.
void Projection::find_psi(grid::VectorField& velocity, double duration) {
  const parallel::Profile::Scope scope(profile_, parallel::Phase::kPoisson);
  const grid::RowSpan all{0, grid_.ny};
  const bool wraps = halo_.wraps_in_x();
  if (!wraps) halo_.fill_side(grid::Side::kHighX, {&velocity.x}, all);
  halo_.fill_side(grid::Side::kHighZ, {&velocity.z}, all);
  DivergenceAndPsi rows(velocity, duration, grid_, psi_, row_sums_.data(), wraps);
  poisson_.solve(rows);
  if (!wraps) halo_.fill_side(grid::Side::kLowX, {&psi_}, all);
  halo_.fill_side(grid::Side::kLowZ, {&psi_}, all);
}

/// One sweep, ghost cells of the velocity in x included. Gradients look to lower cells only, and so does the
/// next predictor's of the pressure: its ghost cells there are renewed with what its neighbour adds, all
/// others are left alone.
void Projection::correct(grid::VectorField& velocity, grid::Field& pressure, double duration, double push) {
  const parallel::Profile::Scope scope(profile_, parallel::Phase::kCorrection);
  const auto& g = grid_;
  const auto u = velocity.x.view(), v = velocity.y.view(), w = velocity.z.view(), p = pressure.view();
  const auto psi = std::as_const(psi_).view();
  const Real by_x = Real(duration / g.dx), by_z = Real(duration / g.dz), more = Real(push);
  const bool wraps = halo_.wraps_in_x();
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      const Real by_y = j > 0 ? Real(duration * g.inv_dy_face[j]) : 0;  // row 0 of v lies on the wall
      p(-1, j, k) += psi(-1, j, k);
#pragma omp simd
      for (int i = 0; i < g.nx; ++i) {
        u(i, j, k) += more - by_x * (psi(i, j, k) - psi(i - 1, j, k));
        v(i, j, k) -= by_y * (psi(i, j, k) - psi(i, j - 1, k));
        w(i, j, k) -= by_z * (psi(i, j, k) - psi(i, j, k - 1));
        p(i, j, k) += psi(i, j, k);
      }
      if (!wraps) continue;
      for (const auto* q : {&u, &v, &w}) grid::wrap_row(&(*q)(0, j, k), g.nx, 1);
    }
  }
  if (!wraps) halo_.fill_in_x({&velocity.x, &velocity.y, &velocity.z}, {0, g.ny});
  grid::for_each_cell({0, g.nx, 0, g.ny, -1, 0}, [=](int i, int j, int k) { p(i, j, k) += psi(i, j, k); });
}

double max_divergence(const grid::VectorField& velocity, const Grid& g,
                      const parallel::Decomposition& decomposition) {
  const Divergence divergence(velocity, g);
  const Real* inv_dy = g.inv_dy.data();
  const double here = grid::max_cells(grid::all_cells(g), 0.0, [=](int i, int j, int k) {
    return std::abs(divergence.at(i, j, k, inv_dy[j]));
  });
  return parallel::maximum(decomposition.all(), here);
}

}  // namespace softwall::pressure
