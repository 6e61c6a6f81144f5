// mpirun -n RANKS step_benchmark [--benchmark_filter=...] : wall-clock nanoseconds per cell and time step.
// The speed of a whole step as the solver makes it: choose dt, then advance. Nothing is written to disk.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/parallel/mpi.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"

namespace softwall {
namespace {

constexpr int kWarmUpSteps = 3, kSteps = 10, kRepetitions = 5;
/// Far beyond what a slow and busy machine needs: only a blunder in the algorithm is slower.
constexpr double kMostNanoseconds = 500'000;

struct Sample {
  const char* name;
  const char* case_json;
};
constexpr Sample kSamples[] = {
    {"rigid_channel/128x96x96",
     R"({"format": 1, "run": {"end_time": 1},
         "physics": {"flow": "rigid_channel", "grid": {"nx": 128, "ny_fluid": 96, "nz": 96, "stretching": 1.3}}})"},
    {"elastic_wall/128x(96+24)x96",
     R"({"format": 1, "run": {"end_time": 1},
         "physics": {"flow": "elastic_wall", "solid": {"G": 1},
                     "grid": {"nx": 128, "ny_fluid": 96, "ny_solid": 24, "nz": 96, "stretching": 1.3}}})"},
    {"short/rigid_channel/32x32x32",
     R"({"format": 1, "run": {"end_time": 1},
         "physics": {"flow": "rigid_channel", "grid": {"nx": 32, "ny_fluid": 32, "nz": 32, "stretching": 1.3}}})"},
    {"short/elastic_wall/32x(32+8)x32",
     R"({"format": 1, "run": {"end_time": 1},
         "physics": {"flow": "elastic_wall", "solid": {"G": 1},
                     "grid": {"nx": 32, "ny_fluid": 32, "ny_solid": 8, "nz": 32, "stretching": 1.3}}})"},
};

/// Wall-clock seconds of one step: of the slowest rank, all having begun together.
double timed_step(time::State& state, time::Setup& setup) {
  MPI_Comm everyone = setup.decomposition.all().get();
  parallel::check(MPI_Barrier(everyone), "MPI_Barrier");
  const double begin = MPI_Wtime();
  time::advance(state, setup, time::choose_time_step(state, setup).dt);
  double seconds = MPI_Wtime() - begin;
  parallel::check(MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, everyone), "MPI_Allreduce");
  return seconds;
}

void measure_steps(benchmark::State& loop, const Sample& sample) {
  const Physics physics = parse_case(sample.case_json).physics;
  time::Setup setup(physics, MPI_COMM_WORLD);
  time::State state = time::perturbed_laminar(setup);
  for (int step = 0; step < kWarmUpSteps; ++step) timed_step(state, setup);

  double seconds = 0;
  for ([[maybe_unused]] auto iteration : loop) {
    const double step = timed_step(state, setup);
    loop.SetIterationTime(step);
    seconds += step;
  }
  const double cells = double(physics.grid.nx) * physics.grid.ny() * physics.grid.nz;
  loop.counters["ns_per_cell_step"] = 1e9 * seconds / kSteps / cells;
  loop.counters["ranks"] = setup.decomposition.all().size();
  if (!time::is_finite(state, setup.decomposition)) loop.SkipWithError("the flow is not finite");
}

/// One plain line a sample, on one rank; notices what no working build shows. JSON: --benchmark_out=FILE.
class Reporter : public benchmark::BenchmarkReporter {
 public:
  explicit Reporter(bool prints) : prints_(prints) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    if (runs.front().run_type == Run::RT_Aggregate) return;
    std::vector<double> speeds;
    for (const Run& run : runs)
      if (!run.error_occurred) speeds.push_back(run.counters.at("ns_per_cell_step"));
    std::sort(speeds.begin(), speeds.end());
    if (speeds.empty() || !(speeds.front() < kMostNanoseconds)) ++bad_;
    if (!prints_) return;
    std::cout << runs.front().run_name.function_name << ", " << name_of(grid::kPrecision) << ", "
              << runs.front().counters.at("ranks") << " ranks: ";
    if (speeds.empty()) {
      std::cout << runs.front().error_message << std::endl;
    } else {
      std::cout << std::lround(speeds[speeds.size() / 2]) << " ns per cell and step (median of "
                << speeds.size() << " x " << kSteps << " steps; " << std::lround(speeds.front()) << " to "
                << std::lround(speeds.back()) << ")" << std::endl;
    }
  }
  [[nodiscard]] int bad() const { return bad_; }

 private:
  bool prints_;
  int bad_ = 0;
};

int run(int argc, char** argv) {
  const parallel::Session session(&argc, &argv);
  int rank = 0;
  parallel::check(MPI_Comm_rank(MPI_COMM_WORLD, &rank), "MPI_Comm_rank");
  // A fixed number of steps, so that all ranks make the same ones.
  for (const Sample& sample : kSamples)
    benchmark::RegisterBenchmark(sample.name,
                                 [&sample](benchmark::State& loop) { measure_steps(loop, sample); })
        ->Iterations(kSteps)
        ->Repetitions(kRepetitions)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Reporter reporter(rank == 0);
  const std::size_t measured = benchmark::RunSpecifiedBenchmarks(&reporter);
  return measured > 0 && reporter.bad() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace softwall

int main(int argc, char** argv) { return softwall::run(argc, argv); }
