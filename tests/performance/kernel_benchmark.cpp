#include <benchmark/benchmark.h>

#include <vector>

#include "solver/fluid/momentum_sweep.hpp"
#include "solver/pressure/fft.hpp"
#include "solver/pressure/tridiagonal.hpp"
#include "solver/solid/reference_map/strain_sweep.hpp"
#include "solver/solid/reference_map/transport.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/no_follower.hpp"

/// The dear kernels of a step alone, on a piece of a channel that stays in a core's own cache: what computing
/// costs where memory does not count. Items are cells (of transforms: real numbers), so items_per_second
/// tells how many a core does; step_benchmark says what is left of it in a whole step.
namespace softwall {
namespace {

using grid::Grid;
using grid::Real;
using support::Domain;

constexpr Domain::Size kCells{128, 16, 4};

/// A channel with noise for a velocity and a displacement.
struct Piece {
  Domain domain{MPI_COMM_WORLD, kCells, {}, support::faces(kCells.ny, 2, 1.4)};
  const Grid& g = domain.grid;
  grid::VectorField velocity{g, 1}, displacement{g, 3};
  grid::Field ones{g, 1}, none{g, 1};

  Piece() {
    int seed = 0;
    const auto fill = [&](grid::Field& f, int ghost, double size) {
      ++seed;
      grid::for_each_cell(
          {-ghost, g.nx + ghost, -ghost, g.ny + ghost, -ghost, g.nz + ghost},
          [&](int i, int j, int k) { f(i, j, k) = Real(size * support::noise(seed, i, j, k)); });
    };
    for (grid::Field* f : {&velocity.x, &velocity.y, &velocity.z}) fill(*f, 1, 1);
    for (grid::Field* f : {&displacement.x, &displacement.y, &displacement.z}) fill(*f, 3, 0.02);
    grid::for_each_cell({-1, g.nx + 1, -1, g.ny + 1, -1, g.nz + 1},
                        [&](int i, int j, int k) { ones(i, j, k) = 1; });
  }
  void count(benchmark::State& state) const {
    state.SetItemsProcessed(std::int64_t(state.iterations()) * g.nx * g.ny * g.nz);
  }
};

void momentum(benchmark::State& state) {
  const Piece p;
  const Grid& g = p.g;
  const fluid::MomentumInput m = fluid::momentum_input(p.velocity, g, 1e-3);
  fluid::MomentumSweep sweep(g);
  for (auto _ : state)
    sweep.for_each_row(m, 0, g.ny,
                       [](int, int, const fluid::MomentumRow& r) { benchmark::DoNotOptimize(r.x[0]); });
  p.count(state);
}
BENCHMARK(momentum);

void map_rates(benchmark::State& state, WenoWeights weights) {
  using namespace solid::reference_map;
  const Piece p;
  const Grid& g = p.g;
  RelaxationSpeeds speeds(g);
  speeds.set(1e-3);
  grid::VectorField rates(g, 0);
  for (auto _ : state) {
    for (int k = 0; k < g.nz; ++k) {
      find_rates(p.displacement, p.velocity, VolumeRelaxation(speeds, p.none), g, weights, {k, 0},
                 {rates.x.view(), rates.y.view(), rates.z.view()});
    }
    benchmark::ClobberMemory();
  }
  p.count(state);
}
BENCHMARK_CAPTURE(map_rates, z, WenoWeights::kZ);
BENCHMARK_CAPTURE(map_rates, jiang_shu, WenoWeights::kJiangShu);

void strain(benchmark::State& state) {
  using namespace solid::reference_map;
  const Piece p;
  grid::TensorField B(p.g, 1);
  grid::Field error(p.g, 1);
  StrainSweep sweep(p.g);
  Damage damage({1}, p.g);
  support::NoFollower nobody;
  for (auto _ : state) {
    sweep.run(strain_of(p.displacement, p.g), p.ones.view(), 0,
              {B.xx.view(), B.yy.view(), B.zz.view(), B.xy.view(), B.xz.view(), B.yz.view(), error.view()},
              damage, nobody);
    benchmark::ClobberMemory();
  }
  p.count(state);
}
BENCHMARK(strain);

/// There and back.
void pair_of_rows(benchmark::State& state) {
  const auto n = std::size_t(state.range(0));
  std::vector<Real> a(n, Real(1)), b(n, Real(2));
  std::vector<pressure::Complex> a_hat(n / 2 + 1), b_hat(n / 2 + 1);
  pressure::RealRowPairTransform transform{int(n)};
  for (auto _ : state) {
    transform.forward(a.data(), b.data(), a_hat.data(), b_hat.data());
    a_hat[0] = b_hat[0] = 1;  // keeps the numbers from growing turn by turn
    transform.backward(a_hat.data(), b_hat.data(), a.data(), b.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(std::int64_t(state.iterations() * 2 * n));
}
BENCHMARK(pair_of_rows)->Arg(96)->Arg(128)->Arg(192)->Arg(432);

/// One mode in x: a complex number counts as the two real ones it stands for.
void tridiagonals(benchmark::State& state) {
  const Piece p;
  const std::size_t systems = 2 * 128;
  pressure::Tridiagonals solver(p.g, systems);
  std::vector<Real> values(systems * std::size_t(p.g.ny), Real(1));
  const std::vector<Real> kappa2(systems, Real(100));
  const Real kappa2_x = 1, scale = 101;  // of all kappa^2; keeps numbers from vanishing
  for (auto _ : state) {
    solver.solve(values.data(), std::ptrdiff_t(systems), kappa2_x, kappa2, scale);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(std::int64_t(state.iterations() * values.size()));
}
BENCHMARK(tridiagonals);

}  // namespace
}  // namespace softwall

int main(int argc, char** argv) {
  const softwall::parallel::Session session(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
