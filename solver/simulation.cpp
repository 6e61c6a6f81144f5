#include "solver/simulation.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <sstream>
#include <vector>

#include "solver/case/time_comparison.hpp"
#include "solver/fluid/stability.hpp"
#include "solver/output/agree.hpp"
#include "solver/output/checkpoint_reader.hpp"
#include "solver/output/checkpoint_writer.hpp"
#include "solver/output/later_attempt.hpp"
#include "solver/output/neighbour.hpp"
#include "solver/output/profile_table.hpp"
#include "solver/output/progress_line.hpp"
#include "solver/output/regrid.hpp"
#include "solver/output/remembered_layout.hpp"
#include "solver/output/runaway.hpp"
#include "solver/output/snapshot.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/pressure/projection.hpp"
#include "solver/run_directory/build_info.hpp"
#include "solver/run_directory/statistics_file.hpp"
#include "solver/statistics/interface_height.hpp"
#include "solver/statistics/solid_health.hpp"
#include "solver/stop_request.hpp"
#include "solver/time/closed_box/closed_box.hpp"
#include "solver/time/initial.hpp"
#include "solver/time/interface_wave.hpp"

namespace softwall {

using output::agree;
using output::agree_on_root;
using output::AgreedError;
using parallel::Phase;

Simulation::Simulation(const Case& definition, const RunOptions& options, const parallel::Communicator& world)
    : case_(definition),
      options_(options),
      world_(world),
      started_(utc_now()),
      setup_(definition.physics, world.get(),
             output::remembered_layout(options.files, definition.physics, world)),
      state_(time::state_at_rest(setup_)),
      statistics_(setup_),
      spectra_(setup_, definition.run.spectra_steps),
      checkpoints_(options.files, definition.id, definition.run.keep_checkpoints),
      snapshots_(output::collection_of_snapshots(options.files)),
      film_(options.files, definition, setup_),
      status_timer_(1.0),
      report_timer_(10.0),
      checkpoint_timer_(definition.run.checkpoint_seconds) {
  checkpoints_.sweep(world_);
  start_or_resume();
  limited_before_ = limited_cells();
  constexpr double kBytesPerSecond = 1e8;  // a guess that the first checkpoint replaces
  checkpoint_duration_ = static_cast<double>(output::checkpoint_bytes(state_, setup_.grid)) / kBytesPerSecond;
}

void Simulation::start_or_resume() {
  const auto found = checkpoints_.newest_valid(world_);
  for (const auto& reason : checkpoints_.refused()) say("passing over " + reason);
  if (found) return resume(*found);
  const auto& initial = case_.physics.initial;
  const auto file = (options_.files.directory / case_.run.initial_checkpoint).lexically_normal();
  if (initial.type == InitialType::kPrecursor) {
    state_ = output::start_from_precursor(file, initial, setup_);
    say("starts from the precursor's " + file.string());
  } else if (initial.type == InitialType::kNeighbour) {
    state_ = output::start_from_neighbour(file, initial, setup_);
    say("starts from its neighbour's " + file.string());
  } else if (is_closed_box(case_.physics.flow)) {
    state_ = time::closed_box_at_start(setup_);
    say(setup_.velocity_prescribed ? "starts in rotation" : "starts from rest");
  } else if (case_.physics.flow == FlowType::kInterfaceWave) {
    state_ = time::interface_wave_at_start(setup_);
    say("starts as a wave of linear theory");
  } else {
    state_ = time::perturbed_laminar(setup_);
    say("starts from a perturbed laminar flow");
  }
  record_.solid_volume_at_start = statistics::solid_health(state_, setup_).solid_volume;
}

void Simulation::resume(const output::FoundCheckpoint& found) {
  record_ = output::load_checkpoint(found.file, found.header, setup_, state_);
  agree(world_, ExitCode::kCheckpointRefused, [&] {
    statistics_.unpack(record_.statistics);
    spectra_.unpack(record_.spectra);
  });
  record_.statistics.clear();
  record_.spectra.clear();
  time::start(state_, setup_);
  checkpoint_step_ = state_.step;
  resumed_from_ = relative(found.file);
  std::ostringstream line;
  line << "resumes from " << resumed_from_ << ": step " << state_.step << ", time " << state_.time;
  say(line.str());
}

ExitCode Simulation::run() {
  setup_.profile.reset();
  Decision next = decide();
  last_step_ = time::choose_time_step(state_, setup_, next.convection_rate);
  write_status();
  if (!has_reached(state_.time, case_.run.end_time)) remove_lost_moments();
  if (state_.step == 0) write_first_moments();
  while (!next.stop() && !has_reached(state_.time, case_.run.end_time)) {
    const double time_before = state_.time;
    step(next.convection_rate);
    next = decide();
    stop_if_diverged(next.convection_rate);
    write_moments(time_before);
    if (next.report) report();
    if (next.checkpoint) write_results();
  }
  return finish(next);
}

void Simulation::step(double convection_rate) {
  pace_.begin_step();
  last_step_ = time::choose_time_step(state_, setup_, convection_rate);
  if (!(state_.time + last_step_.dt > state_.time)) {
    throw AgreedError(ExitCode::kDiverged, "diverged at step " + std::to_string(state_.step) +
                                               ": the time step has shrunk to " +
                                               std::to_string(last_step_.dt));
  }
  time::advance(state_, setup_, last_step_.dt);
  setup_.profile.time(Phase::kStatistics, [&] {
    statistics_.sample_step(state_, last_step_.dt);
    spectra_.sample_step(state_, last_step_.dt);
  });
  pace_.end_step();
  if (status_timer_.due()) write_status();
}

/// Clocks differ between ranks, and a signal may have reached some only: the largest of each wish counts.
Simulation::Decision Simulation::decide() {
  const parallel::Profile::Scope scope(&setup_.profile, Phase::kTimeStep);
  const bool root = world_.rank() == 0;
  const auto& run = case_.run;
  const bool by_steps = run.checkpoint_steps > 0 && state_.step % run.checkpoint_steps == 0;
  const bool by_clock = run.checkpoint_seconds > 0 && root && checkpoint_timer_.due();
  const std::array<double, 5> mine{fluid::convection_rate_here(state_.velocity, setup_.grid),
                                   double(stop_signal()), double(root && time_is_up()),
                                   double(by_steps || by_clock), double(root && report_timer_.due())};
  std::array<double, 5> all{};
  parallel::check(MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MAX,
                                world_.get()),
                  "MPI_Allreduce");
  return {all[0], static_cast<int>(all[1]), all[2] > 0, all[3] > 0, all[4] > 0};
}

/// Before anything of the state is written.
void Simulation::stop_if_diverged(double convection_rate) const {
  if (!output::may_be_runaway(convection_rate, setup_.grid)) return;
  // A prescribed velocity has no scale of its own, but must be a number.
  const double allowed =
      setup_.velocity_prescribed ? std::numeric_limits<double>::max() : output::kFastestVelocity;
  const double fastest = parallel::maximum(world_, output::fastest_here(state_.velocity, setup_.grid));
  if (fastest > allowed) throw AgreedError(ExitCode::kDiverged, output::describe_runaway(state_, fastest));
}

bool Simulation::time_is_up() const {
  if (options_.wall_seconds <= 0) return false;
  const double still_needed = 2 * (checkpoint_duration_ + pace_.seconds_per_step()) + frames_duration_;
  return output::Timer::seconds_since(options_.started) + still_needed >= options_.wall_seconds;
}

void Simulation::checkpoint() {
  if (checkpoint_step_ == state_.step) return;
  const parallel::Profile::Scope scope(&setup_.profile, Phase::kOutput);
  const auto begin = output::Clock::now();
  output::CheckpointContents now = record_;
  now.statistics = statistics_.pack();
  now.spectra = spectra_.pack();
  now.limited_cells += limited_cells() - limited_before_;
  const auto file =
      output::write_checkpoint(options_.files, {case_.id, options_.attempt}, state_, now, setup_);
  checkpoints_.prune(file, world_);
  checkpoint_step_ = state_.step;
  checkpoint_timer_.reset();
  checkpoint_duration_ = output::Timer::seconds_since(begin);
}

/// Those of an attempt that got further than the checkpoint from which this one goes on.
void Simulation::remove_lost_moments() {
  agree_on_root(world_, ExitCode::kIoFailure, [&] {
    snapshots_.remove_later_than(options_.files.fields_of(state_.step));
    film_.remove_later_than(state_.step);
  });
}

/// What later shapes are compared with.
void Simulation::write_first_moments() {
  if (case_.run.field_interval > 0) write_snapshot();
  if (case_.run.plane_interval > 0) write_planes();
}

/// Those whose interval has passed with the last step.
void Simulation::write_moments(double time_before) {
  const auto is_due = [&](double interval) {
    return interval > 0 && intervals_passed(state_.time, interval) != intervals_passed(time_before, interval);
  };
  const auto begin = output::Clock::now();
  if (is_due(case_.run.field_interval)) write_snapshot();
  if (is_due(case_.run.plane_interval)) write_planes();
  frames_duration_ = std::max(frames_duration_, output::Timer::seconds_since(begin));
}

void Simulation::write_snapshot() {
  const parallel::Profile::Scope scope(&setup_.profile, Phase::kOutput);
  output::write_snapshot(options_.files, state_, setup_, snapshots_);
}

void Simulation::write_planes() {
  if (film_.none()) return;
  const parallel::Profile::Scope scope(&setup_.profile, Phase::kOutput);
  film_.write(state_, film_.has_layer() ? statistics::heights_of_interface(state_.material, setup_.grid)
                                        : std::vector<double>());
}

/// The averages so far stand beside every checkpoint, so that a case can be judged before its end.
void Simulation::write_results() {
  output::leave_to_later_attempt(options_.files, case_.id, options_.attempt, world_);
  checkpoint();
  const parallel::Profile::Scope scope(&setup_.profile, Phase::kOutput);
  const auto arrays = spectra_.arrays();
  agree_on_root(world_, ExitCode::kFailed, [&] {
    auto blocks = statistics_.blocks();
    blocks.case_id = case_.id;
    analysis::write_statistics(options_.files.statistics(), blocks);
    if (!arrays.empty()) analysis::write_arrays(options_.files.spectra(), case_.id, arrays);
  });
}

ExitCode Simulation::finish(const Decision& last) {
  report();
  write_results();
  const bool finished = has_reached(state_.time, case_.run.end_time);
  const ExitCode code = finished ? ExitCode::kDone : ExitCode::kInterrupted;
  std::string reason = "end time reached";
  if (!finished) reason = last.signal != 0 ? describe_stop_signal(last.signal) : "wall-clock limit";
  summarise(code, reason);
  write_status();
  std::ostringstream line;
  line << outcome_of(code) << " (" << reason << ") at step " << state_.step << ", time " << state_.time
       << " of " << case_.run.end_time << "; " << pace_.steps() << " steps, "
       << pace_.ns_per_cell_step(setup_.grid.cells()) << " ns per cell and step";
  say(line.str());
  if (options_.profile) {
    const auto records = output::gather_profile(setup_.profile, world_);
    say(output::profile_table(records, pace_.steps(), setup_.grid.cells(), world_.size()));
  }
  return code;
}

void Simulation::report() {
  const parallel::Profile::Scope scope(&setup_.profile, Phase::kOutput);
  report_timer_.reset();
  const double divergence =
      pressure::max_divergence(state_.velocity, setup_.grid, setup_.decomposition) * setup_.grid.dx;
  divergence_ = std::max(divergence_, divergence);
  say(output::progress_line(state_, setup_,
                            {last_step_, divergence, 1e9 * pace_.seconds_per_step() / setup_.grid.cells()}));
}

void Simulation::say(const std::string& line) const {
  if (world_.rank() != 0) return;
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

}  // namespace softwall
