#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "solver/case/case.hpp"
#include "solver/output/checkpoint_contents.hpp"
#include "solver/output/checkpoints.hpp"
#include "solver/output/collection.hpp"
#include "solver/output/film.hpp"
#include "solver/output/pace.hpp"
#include "solver/output/reports.hpp"
#include "solver/run_directory/exit_codes.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/statistics/spectra.hpp"
#include "solver/statistics/statistics.hpp"
#include "solver/time/advance.hpp"

namespace softwall {

struct RunOptions {
  RunFiles files;
  int attempt = 0;
  double wall_seconds = 0;  ///< stop in order before so much time has passed; 0: no limit
  bool profile = false;     ///< say at the end where the time went
  bool snapshot = false;    ///< make a snapshot of the newest checkpoint and nothing else
  output::Clock::time_point started = output::Clock::now();
};

/// One attempt at a case: from its newest checkpoint, or from the beginning, to its end time or to a request
/// to stop. All functions are collective.
class Simulation {
 public:
  /// The caller holds the run's lock. Throws AgreedError when there are checkpoints and none can be resumed.
  Simulation(const Case& definition, const RunOptions& options, const parallel::Communicator& world);

  /// Steps until the end. Throws AgreedError with what went wrong.
  [[nodiscard]] ExitCode run();

  /// Whether the state is that of a checkpoint.
  [[nodiscard]] bool has_resumed() const { return !resumed_from_.empty(); }
  /// Writes a snapshot of the state as it is. Throws AgreedError.
  void write_snapshot();

  /// Writes summary.json for an attempt that ends with this code.
  void summarise(ExitCode code, const std::string& reason);

 private:
  /// What all ranks agree to do after a step.
  struct Decision {
    double convection_rate = 0;  ///< fluid/stability.hpp
    int signal = 0;
    bool out_of_time = false, checkpoint = false, report = false;
    [[nodiscard]] bool stop() const { return signal != 0 || out_of_time; }
  };

  void start_or_resume();
  void resume(const output::FoundCheckpoint& found);
  void step(double convection_rate);
  [[nodiscard]] Decision decide();
  void stop_if_diverged(double convection_rate) const;
  [[nodiscard]] bool time_is_up() const;
  void checkpoint();
  void remove_lost_moments();
  void write_first_moments();
  void write_moments(double time_before);
  void write_planes();
  void report();
  void write_status();
  void write_results();
  [[nodiscard]] ExitCode finish(const Decision& last);
  [[nodiscard]] double limited_cells() const;
  [[nodiscard]] std::map<std::string, double> diagnostics();
  [[nodiscard]] std::string relative(const std::filesystem::path& file) const;
  void say(const std::string& line) const;

  const Case case_;
  const RunOptions options_;
  const parallel::Communicator& world_;
  const std::string started_;
  time::Setup setup_;
  time::State state_;
  statistics::Statistics statistics_;
  statistics::Spectra spectra_;
  output::Checkpoints checkpoints_;
  output::Collection snapshots_;
  output::Film film_;
  output::CheckpointContents record_;
  double limited_before_ = 0;  ///< cells this program's limiter had touched when the record was read
  double divergence_ = 0;      ///< largest seen in this attempt, times dx / U_b
  time::TimeStep last_step_{0, "fixed"};
  std::int64_t checkpoint_step_ = -1;
  double checkpoint_duration_ = 0;  ///< of the last one, s
  double frames_duration_ = 0;      ///< of the longest snapshot and film frame of a step, s
  std::string resumed_from_;
  output::Pace pace_;
  output::Timer status_timer_, report_timer_, checkpoint_timer_;
};

/// The whole of one attempt: reads case.json, runs, reports. Returns the program's exit code; prints messages
/// on rank 0. Throws only what a single rank met alone.
[[nodiscard]] ExitCode run_case(const RunOptions& options, MPI_Comm comm);

}  // namespace softwall
