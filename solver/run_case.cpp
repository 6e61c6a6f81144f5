#include <cstdio>
#include <memory>
#include <optional>
#include <sstream>

#include "solver/case/bad_input.hpp"
#include "solver/case/input_file.hpp"
#include "solver/output/agree.hpp"
#include "solver/output/later_attempt.hpp"
#include "solver/output/parallel_file.hpp"
#include "solver/output/run_lock.hpp"
#include "solver/run_directory/build_info.hpp"
#include "solver/run_directory/programs.hpp"
#include "solver/simulation.hpp"

namespace softwall {

namespace {

/// Read once, so that all ranks see the same text; parsed by all.
Case read_shared_case(const RunFiles& files, const parallel::Communicator& world) {
  std::string text;
  output::agree_on_root(world, ExitCode::kBadCase, [&] { text = read_input_file(files.case_file()); });
  text = output::from_root(world, text);
  std::optional<Case> parsed;
  output::agree(world, ExitCode::kBadCase, [&] {
    try {
      parsed = parse_case(text);
    } catch (const BadInput& error) {
      throw BadInput(files.case_file().string(), error.mistakes);
    }
  });
  return *parsed;
}

/// main() has changed to the program of the right precision, if it could.
void require_precision(const Case& c) {
  const Precision wanted = c.physics.precision;
  if (wanted == grid::kPrecision) return;
  throw output::AgreedError(ExitCode::kFailed, "this program computes in " + name_of(grid::kPrecision) +
                                                   " precision, physics.precision is " + name_of(wanted) +
                                                   ": cannot start " +
                                                   solver_program(folder_of_this_program(), wanted).string());
}

const char* words_for(FlowType flow) {
  switch (flow) {
    case FlowType::kRigidChannel:
      return "rigid channel";
    case FlowType::kElasticWall:
      return "elastic wall";
    case FlowType::kCavity:
      return "cavity";
    case FlowType::kRotation:
      return "rotation";
    case FlowType::kInterfaceWave:
      return "interface wave";
  }
  return "";
}

std::string introduction(const Case& c, const RunOptions& options, int ranks) {
  const BuildInfo build = build_info();
  const auto& p = c.physics;
  std::ostringstream text;
  text << "softwall-dns " << build.version << " (" << build.git_revision << ", " << build.build_type << ", "
       << build.compiler << "), " << ranks << (ranks == 1 ? " rank on " : " ranks on ") << host_name() << "\n"
       << "case " << c.id << " \"" << printable_excerpt(c.label) << "\", attempt " << options.attempt << ": "
       << words_for(p.flow) << ", Re " << p.reynolds;
  if (p.solid) {
    text << ", G " << p.solid->G;
    if (p.solid->mooney_share > 0) text << " (Mooney-Rivlin, c2 / G " << p.solid->mooney_share << ")";
    text << ", viscosity ratio " << p.solid->viscosity_ratio
         << (p.solid->formulation == SolidFormulation::kReferenceMap ? ", reference map" : ", transported B");
  }
  text << ", grid " << p.grid.nx << " x " << p.grid.ny() << " x " << p.grid.nz << ", to time "
       << c.run.end_time << ", in " << name_of(p.precision) << " precision";
  return text.str();
}

/// An attempt that could not begin. A case that has finished before keeps its summary.
void summarise_failure(const Case& c, const RunOptions& options, const parallel::Communicator& world,
                       const output::AgreedError& error) {
  auto s = output::report_on<Summary>(c, options.attempt, world.size());
  s.reason = error.what();
  s.started = utc_now();
  output::agree_on_root(world, ExitCode::kFailed, [&] {
    if (!output::says_finished(options.files, c.id)) output::write_summary(options.files, error.code, s);
  });
}

std::unique_ptr<Simulation> begin(const Case& c, const RunOptions& options,
                                  const parallel::Communicator& world) {
  try {
    return std::make_unique<Simulation>(c, options, world);
  } catch (const output::AgreedError& error) {
    if (!options.snapshot) summarise_failure(c, options, world, error);
    throw;
  } catch (const std::invalid_argument& error) {  // more ranks than the grid can feed
    throw output::AgreedError(ExitCode::kBadCase, error.what());
  }
}

ExitCode simulate(const Case& c, const RunOptions& options, const parallel::Communicator& world) {
  const output::RunLock lock(options.files, world);
  output::leave_to_later_attempt(options.files, c.id, options.attempt, world);
  const auto simulation = begin(c, options, world);
  if (options.snapshot) {
    if (!simulation->has_resumed())
      throw output::AgreedError(ExitCode::kBadCase, "there is no checkpoint of which to make a snapshot");
    simulation->write_snapshot();
    return ExitCode::kDone;
  }
  try {
    return simulation->run();
  } catch (const output::ReplacedAttempt&) {
    throw;  // the later one has the say in the run directory
  } catch (const output::AgreedError& error) {
    simulation->summarise(error.code, error.what());
    throw;
  }
}

}  // namespace

ExitCode run_case(const RunOptions& options, MPI_Comm comm) {
  output::prepare_hdf5();
  const auto world = parallel::Communicator::duplicate(comm);
  try {
    const Case c = read_shared_case(options.files, world);
    require_precision(c);
    if (world.rank() == 0) {
      std::printf("%s\n", introduction(c, options, world.size()).c_str());
      std::fflush(stdout);
    }
    return simulate(c, options, world);
  } catch (const output::AgreedError& error) {
    if (world.rank() == 0) std::fprintf(stderr, "softwall-dns: %s\n", error.what());
    return error.code;
  }
}

}  // namespace softwall
