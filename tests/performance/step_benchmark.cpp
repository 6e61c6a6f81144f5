// mpirun -n RANKS step_benchmark [--short] [--sample NAME] [--repetitions N] [--folder FOLDER]
// The speed of a whole step as the solver makes it: choose dt, then advance. Prints one line of JSON, on rank
// 0: for each sample, or the named one only, nanoseconds per cell and step, the phases, messages, allocations
// and memory; and the bandwidth that the same ranks reach at the same time. Samples: "rigid", "elastic" (the
// formulation of the solid that a case has by default), "elastic_NAME" for every other formulation, and
// "elastic_explicit" for the default one with all stress explicit. With a
// folder it also writes checkpoints there, in turns with dd.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
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

constexpr int kWarmUpSteps = 3, kSteps = 10;
/// Traffic of a step, numbers per cell, if every sweep that cannot be part of another one reads and writes
/// each field once. A write counts twice where nothing was read before: the cache fetches the line first.
/// Exchanges between ranks on one machine add nothing, since each reads the other's values where they are.
double numbers_of_a_fused_step() {
  const double velocity = 3, pressure = 1, psi = 1, spectrum = 1;  // nx / 2 + 1 complex numbers a row
  const double predictor = velocity + pressure + 2 * 3 /* rates, in place */ + 2 * velocity;
  const double to_spectrum = velocity + 2 * spectrum, in_spectrum = 2 * spectrum;
  const double from_spectrum = spectrum + 2 * psi;
  const double correction = 2 * velocity + 2 * pressure + psi;
  const double time_step = velocity;
  return 3 * (predictor + to_spectrum + in_spectrum + from_spectrum + correction) + time_step;
}

struct Options {
  bool is_short = false;
  int repetitions = 5;       ///< of kSteps steps
  std::string only, folder;  ///< one sample; where checkpoints go
};

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (argument == "--short") options.is_short = true;
    if (argument == "--sample") options.only = value();
    if (argument == "--repetitions") options.repetitions = std::max(1, std::atoi(value()));
    if (argument == "--folder") options.folder = value();
  }
  return options;
}

/// Cells in x and z, below and in the layer.
struct Cells {
  int nx, nz, ny_fluid, ny_solid;
};
constexpr Cells kLong{128, 128, 96, 24}, kShort{32, 32, 32, 8};

struct Sample {
  std::string name;
  Physics physics;
};

json definition_of(const char* flow, const Cells& cells) {
  json definition{{"format", 1}, {"run", {{"end_time", 1}}}};
  json& physics = definition["physics"];
  physics["flow"] = flow;
  physics["grid"] = {{"nx", cells.nx}, {"ny_fluid", cells.ny_fluid}, {"nz", cells.nz}, {"stretching", 1.3}};
  return definition;
}

/// A rigid channel, and the same with a layer more in every formulation, the default one first.
std::vector<Sample> samples_of(const Cells& cells) {
  std::vector<Sample> samples{{"rigid", parse_case(definition_of("rigid_channel", cells).dump()).physics}};
  json elastic = definition_of("elastic_wall", cells);
  elastic["physics"]["grid"]["ny_solid"] = cells.ny_solid;
  elastic["physics"]["solid"]["G"] = 1;
  samples.push_back({"elastic", parse_case(elastic.dump()).physics});
  for (const std::string formulation : {"transported_B", "reference_map"}) {
    elastic["physics"]["solid"]["formulation"] = formulation;
    const Physics physics = parse_case(elastic.dump()).physics;
    if (physics.solid->formulation != samples[1].physics.solid->formulation)
      samples.push_back({"elastic_" + formulation, physics});
  }
  elastic["physics"]["solid"] = {{"G", 1}, {"stiffness", "explicit"}};
  samples.push_back({"elastic_explicit", parse_case(elastic.dump()).physics});
  return samples;
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

/// Seconds in which dd writes and syncs so many bytes of zeros to the disk that holds the folder.
double seconds_of_dd(const std::filesystem::path& folder, std::int64_t bytes) {
  const auto file = folder / "dd.tmp";
  const std::string command = "dd if=/dev/zero of='" + file.string() +
                              "' bs=1M conv=fsync count=" + std::to_string((bytes + (1 << 19)) >> 20) +
                              " 2>/dev/null";
  const double begin = MPI_Wtime();
  const int status = std::system(command.c_str());
  const double seconds = MPI_Wtime() - begin;
  if (status != 0) throw std::runtime_error("cannot run: " + command);
  std::filesystem::remove(file);
  return seconds;
}

/// A barrier in which the ranks that wait leave their cores to others.
void meet_asleep(const parallel::Communicator& world) {
  MPI_Request request = MPI_REQUEST_NULL;
  parallel::check(MPI_Ibarrier(world.get(), &request), "MPI_Ibarrier");
  for (int met = 0; met == 0;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    parallel::check(MPI_Test(&request, &met, MPI_STATUS_IGNORE), "MPI_Test");
  }
}

/// Seconds to write a checkpoint, and for dd to write as much, in turns, on the same disk; the ratio within a
/// turn; and the size.
json measure_checkpoint(time::State& state, time::Setup& setup, const std::filesystem::path& folder) {
  const auto& world = setup.decomposition.all();
  const std::int64_t bytes = output::checkpoint_bytes(state, setup.grid);
  // The first turns do not count: they take memory that the machine has to find first (the first of all took
  // three times as long as the fourth).
  constexpr int kFirst = 3, kTurns = 5;
  std::vector<double> seconds, dd_seconds, ratios;
  for (int turn = -kFirst; turn < kTurns; ++turn) {
    const double by_dd = world.rank() == 0 ? seconds_of_dd(folder, bytes) : 0;
    ++state.step;  // each under its own name
    meet_asleep(world);
    const double begin = MPI_Wtime();
    const auto file = output::write_checkpoint({folder}, {"benchmark", 0}, state, {}, setup);
    const double by_solver = parallel::maximum(world, MPI_Wtime() - begin);
    if (world.rank() == 0) std::filesystem::remove(file);
    if (turn < 0) continue;
    seconds.push_back(by_solver);
    dd_seconds.push_back(by_dd);
    ratios.push_back(by_dd / by_solver);
  }
  return {{"seconds", median(seconds)},
          {"dd_seconds", median(dd_seconds)},
          {"over_dd", median(ratios)},
          {"bytes", bytes}};
}

json measure(const Sample& sample, const Options& options, const parallel::Communicator& world) {
  const double before = resident();
  time::Setup setup(sample.physics, MPI_COMM_WORLD);
  time::State state = time::perturbed_laminar(setup);
  statistics::Statistics statistics(setup);
  for (int step = 0; step < kWarmUpSteps; ++step) timed_step(state, setup);

  const double cells = setup.grid.cells();
  setup.profile.reset(true);
  std::vector<double> speeds;
  std::int64_t allocated = 0;
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    double seconds = 0;
    for (int step = 0; step < kSteps; ++step) {
      const std::int64_t allocations_before = support::allocations();
      seconds += timed_step(state, setup);
      allocated += support::allocations() - allocations_before;
      setup.profile.time(parallel::Phase::kStatistics, [&] { statistics.sample_step(state, 1e-3); });
    }
    speeds.push_back(1e9 * seconds / (kSteps * cells));
  }
  const int all = kSteps * options.repetitions;
  json result{{"grid", {setup.grid.nx_global, setup.grid.ny, setup.grid.nz_global}},
              {"ns", median(speeds)},
              {"ns_min", *std::min_element(speeds.begin(), speeds.end())},
              {"ns_max", *std::max_element(speeds.begin(), speeds.end())},
              {"phases", phases_of(setup, cells, all)},
              {"allocations_per_step", parallel::sum(world, double(allocated)) / all},
              {"bytes_per_cell", parallel::sum(world, resident() - before) / cells},
              {"finite", time::is_finite(state, setup.decomposition)}};
  if (!options.folder.empty()) result["checkpoint"] = measure_checkpoint(state, setup, options.folder);
  return result;
}

int run(int argc, char** argv) {
  const parallel::Session session(&argc, &argv);
  const auto world = parallel::Communicator::duplicate(MPI_COMM_WORLD);
  const Options options = options_of(argc, argv);
  const double bandwidth = triad(world);
  json all{{"ranks", world.size()},
           {"precision", sizeof(grid::Real) == sizeof(double) ? "double" : "single"},
           {"triad_gb_s", 1e-9 * bandwidth},
           {"traffic_bound_ns", 1e9 * numbers_of_a_fused_step() * sizeof(grid::Real) / bandwidth}};
  bool sound = bandwidth > 0;
  for (const Sample& sample : samples_of(options.is_short ? kShort : kLong)) {
    if (!options.only.empty() && sample.name != options.only) continue;
    all[sample.name] = measure(sample, options, world);
    sound = sound && all[sample.name]["finite"] && all[sample.name]["ns"] > 0;
  }
  if (world.rank() == 0) std::cout << all.dump() << std::endl;
  return sound ? 0 : 1;
}

}  // namespace
}  // namespace softwall

int main(int argc, char** argv) { return softwall::run(argc, argv); }
