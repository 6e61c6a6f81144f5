// mpirun -n RANKS step_benchmark [--short] [--folder FOLDER]
// The speed of a whole step as the solver makes it: choose dt, then advance. Prints one line of JSON, on rank
// 0: for each sample nanoseconds per cell and step, the phases, messages, allocations and memory; and the
// bandwidth that the same ranks reach at the same time. With a folder it also writes checkpoints there.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <unistd.h>

#include "solver/case/case_json.hpp"
#include "solver/output/checkpoint_writer.hpp"
#include "solver/output/profile_table.hpp"
#include "solver/parallel/line_memory.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/statistics/statistics.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "tests/performance/allocations.hpp"

namespace softwall {
namespace {

using nlohmann::json;

constexpr int kWarmUpSteps = 3, kSteps = 10, kRepetitions = 5;
/// Traffic of a step in double precision if each substep reads and writes every field once in each of its
/// sweeps that cannot be one: 3 x (predictor 128, right-hand side to spectrum and back 64, its exchange 30,
/// correction 72) and the time step's 24, a write counting its read.
constexpr double kBytesOfAFusedStep = 955;

struct Sample {
  const char* name;
  const char* flow;
  int nx, ny_fluid, ny_solid, nz;
};
constexpr Sample kLong[] = {{"rigid", "rigid_channel", 128, 96, 0, 128},
                            {"elastic", "elastic_wall", 128, 96, 24, 128}};
constexpr Sample kShort[] = {{"rigid", "rigid_channel", 32, 32, 0, 32},
                             {"elastic", "elastic_wall", 32, 32, 8, 32}};

Physics physics_of(const Sample& s) {
  json definition{{"format", 1}, {"run", {{"end_time", 1}}}};
  json& physics = definition["physics"];
  physics["flow"] = s.flow;
  physics["grid"] = {{"nx", s.nx}, {"ny_fluid", s.ny_fluid}, {"nz", s.nz}, {"stretching", 1.3}};
  if (s.ny_solid > 0) {
    physics["grid"]["ny_solid"] = s.ny_solid;
    physics["solid"] = {{"G", 1}};
  }
  return parse_case(definition.dump()).physics;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Resident memory of this rank, bytes.
double resident() {
  double pages = 0, ignored = 0;
  std::ifstream("/proc/self/statm") >> ignored >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Bytes per second of a = b + s c on all ranks at once, in the memory that the fields use; the line that a
/// write fetches first is counted.
double triad(const parallel::Communicator& world) {
  constexpr std::size_t kCount = 4'000'000;
  parallel::LineVector<double> a(kCount), b(kCount, 1.0), c(kCount, 2.0);
  double best = 0;
  for (int repetition = 0; repetition < 10; ++repetition) {
    parallel::check(MPI_Barrier(world.get()), "MPI_Barrier");
    const double begin = MPI_Wtime();
    double *const to = a.data(), s = 0.5 * repetition;
    const double *const first = b.data(), *const second = c.data();
#pragma omp simd
    for (std::size_t i = 0; i < kCount; ++i) to[i] = first[i] + s * second[i];
    const double seconds = parallel::maximum(world, MPI_Wtime() - begin);
    best = std::max(best, 4 * sizeof(double) * kCount * world.size() / seconds);
  }
  return a[kCount / 2] > 0 ? best : 0;
}

/// Wall-clock seconds of one step: of the slowest rank, all having begun together.
double timed_step(time::State& state, time::Setup& setup) {
  parallel::check(MPI_Barrier(setup.decomposition.all().get()), "MPI_Barrier");
  const double begin = MPI_Wtime();
  time::advance(state, setup, time::choose_time_step(state, setup).dt);
  return parallel::maximum(setup.decomposition.all(), MPI_Wtime() - begin);
}

json phases_of(time::Setup& setup, double cells, int steps) {
  json phases = json::object();
  const auto records = output::gather_profile(setup.profile, setup.decomposition.all());
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto& r = records[i];
    phases[parallel::kPhaseNames[i]] = {{"ns", 1e9 * r.seconds / (steps * cells)},
                                        {"processor_ns", 1e9 * r.processor_seconds / (steps * cells)},
                                        {"messages", double(r.messages) / steps},
                                        {"bytes", double(r.bytes) / steps}};
  }
  return phases;
}

/// Seconds to write a checkpoint, and its size.
json measure_checkpoint(time::State& state, time::Setup& setup, const std::filesystem::path& folder) {
  std::vector<double> seconds;
  for (int repetition = 0; repetition < 3; ++repetition) {
    ++state.step;  // each under its own name
    parallel::check(MPI_Barrier(setup.decomposition.all().get()), "MPI_Barrier");
    const double begin = MPI_Wtime();
    const auto file = output::write_checkpoint({folder}, {"benchmark", 0}, state, {}, setup);
    seconds.push_back(parallel::maximum(setup.decomposition.all(), MPI_Wtime() - begin));
    if (setup.decomposition.all().rank() == 0) std::filesystem::remove(file);
  }
  return {{"seconds", median(seconds)}, {"bytes", output::checkpoint_bytes(state, setup.grid)}};
}

json measure(const Sample& sample, const parallel::Communicator& world, const std::string& folder) {
  const double before = resident();
  const Physics physics = physics_of(sample);
  time::Setup setup(physics, MPI_COMM_WORLD);
  time::State state = time::perturbed_laminar(setup);
  statistics::Statistics statistics(setup);
  for (int step = 0; step < kWarmUpSteps; ++step) timed_step(state, setup);

  const double cells = setup.grid.cells();
  setup.profile.reset(true);
  std::vector<double> speeds;
  std::int64_t allocated = 0;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    double seconds = 0;
    for (int step = 0; step < kSteps; ++step) {
      const std::int64_t allocations_before = support::allocations();
      seconds += timed_step(state, setup);
      allocated += support::allocations() - allocations_before;
      setup.profile.time(parallel::Phase::kStatistics, [&] { statistics.sample_step(state, 1e-3); });
    }
    speeds.push_back(1e9 * seconds / (kSteps * cells));
  }
  constexpr int kAll = kSteps * kRepetitions;
  json result{{"grid", {sample.nx, sample.ny_fluid + sample.ny_solid, sample.nz}},
              {"ns", median(speeds)},
              {"ns_min", *std::min_element(speeds.begin(), speeds.end())},
              {"ns_max", *std::max_element(speeds.begin(), speeds.end())},
              {"phases", phases_of(setup, cells, kAll)},
              {"allocations_per_step", parallel::sum(world, double(allocated)) / kAll},
              {"bytes_per_cell", parallel::sum(world, resident() - before) / cells},
              {"finite", time::is_finite(state, setup.decomposition)}};
  if (!folder.empty()) result["checkpoint"] = measure_checkpoint(state, setup, folder);
  return result;
}

int run(int argc, char** argv) {
  const parallel::Session session(&argc, &argv);
  const auto world = parallel::Communicator::duplicate(MPI_COMM_WORLD);
  bool is_short = false;
  std::string folder;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--short") is_short = true;
    if (argument == "--folder" && i + 1 < argc) folder = argv[++i];
  }
  const double bandwidth = triad(world);
  json all{{"ranks", world.size()},
           {"precision", sizeof(grid::Real) == sizeof(double) ? "double" : "single"},
           {"triad_gb_s", 1e-9 * bandwidth},
           {"traffic_bound_ns", 1e9 * kBytesOfAFusedStep * sizeof(grid::Real) / sizeof(double) / bandwidth}};
  bool sound = bandwidth > 0;
  const auto measure_all = [&](const auto& samples) {
    for (const Sample& sample : samples) {
      all[sample.name] = measure(sample, world, folder);
      sound = sound && all[sample.name]["finite"] && all[sample.name]["ns"] > 0;
    }
  };
  if (is_short) {
    measure_all(kShort);
  } else {
    measure_all(kLong);
  }
  if (world.rank() == 0) std::cout << all.dump() << std::endl;
  return sound ? 0 : 1;
}

}  // namespace
}  // namespace softwall

int main(int argc, char** argv) { return softwall::run(argc, argv); }
