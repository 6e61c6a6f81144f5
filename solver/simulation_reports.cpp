#include <map>
#include <string>
#include <system_error>

#include "solver/output/agree.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/simulation.hpp"
#include "solver/statistics/solid_health.hpp"

// What a simulation says of itself in status.json and summary.json.
namespace softwall {

using parallel::Phase;

/// A full disk must not end a run before a checkpoint fails: a status is only a hint.
void Simulation::write_status() {
  const parallel::Profile::Scope scope(&setup_.profile, Phase::kOutput);
  status_timer_.reset();
  if (world_.rank() != 0) return;
  const std::string limit = last_step_.limit;
  try {
    auto s = output::report_on<Status>(case_, options_.attempt, world_.size());
    s.step = state_.step;
    s.time = state_.time;
    s.dt = last_step_.dt;
    // Format 1 of status.json (schemas/status.schema.json) says advection.
    s.dt_limit = limit == "convection" ? "advection" : limit;
    s.seconds_per_step = pace_.seconds_per_step();
    s.checkpoint_step = checkpoint_step_;
    s.wall_seconds = output::Timer::seconds_since(options_.started);
    output::write_status(options_.files, s);
  } catch (const std::system_error& error) {
    say(std::string("cannot write the status: ") + error.what());
  }
}

double Simulation::limited_cells() const {
  const double here = setup_.solid ? static_cast<double>(setup_.solid->limited_cells()) : 0.0;
  return parallel::sum(world_, here);
}

std::map<std::string, double> Simulation::diagnostics() {
  std::map<std::string, double> all{{"max_divergence", divergence_}};
  if (!setup_.solid) return all;
  const auto health = statistics::solid_health(state_, setup_);
  const double at_start = record_.solid_volume_at_start;
  all["solid_fraction_sum"] = health.solid_volume;
  all["solid_fraction_drift"] = (health.solid_volume - at_start) / at_start;
  all["min_eigenvalue_B"] = health.min_eigenvalue;
  all["max_det_error"] = health.max_det_error;
  all["interface_width_cells"] = health.interface_width_cells;
  const double limited = record_.limited_cells + limited_cells() - limited_before_;
  all["limited_cells"] = limited;
  const double counted_steps = static_cast<double>(state_.step) - record_.limited_since_step;
  if (counted_steps > 0)
    all["limited_share"] = limited / (counted_steps * statistics::solid_cells(state_, setup_));
  return all;
}

void Simulation::summarise(ExitCode code, const std::string& reason) {
  auto s = output::report_on<Summary>(case_, options_.attempt, world_.size());
  s.reason = reason;
  s.step = state_.step;
  s.time = state_.time;
  s.attempt_steps = pace_.steps();
  s.wall_seconds = output::Timer::seconds_since(options_.started);
  s.ns_per_cell_step = pace_.ns_per_cell_step(setup_.grid.cells());
  if (checkpoint_step_ >= 0) s.checkpoint = relative(options_.files.checkpoint(checkpoint_step_));
  s.resumed_from = resumed_from_;
  s.started = started_;
  s.diagnostics = diagnostics();
  output::agree_on_root(world_, ExitCode::kFailed, [&] { output::write_summary(options_.files, code, s); });
}

std::string Simulation::relative(const std::filesystem::path& file) const {
  return file.lexically_relative(options_.files.directory).string();
}

}  // namespace softwall
