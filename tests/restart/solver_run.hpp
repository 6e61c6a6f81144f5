#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "solver/run_directory/run_files.hpp"

/// The real softwall-dns under the real mpirun, in a run directory of its own.
namespace softwall::support {

struct Ended {
  int code = -1;       ///< mpirun's exit status; 128 + signal when it was killed
  std::string output;  ///< of this attempt, stdout and stderr together
};

class SolverRun {
 public:
  SolverRun();
  explicit SolverRun(const nlohmann::json& definition) : SolverRun() { write_case(definition); }
  ~SolverRun();
  SolverRun(const SolverRun&) = delete;
  SolverRun& operator=(const SolverRun&) = delete;

  [[nodiscard]] const RunFiles& files() const { return files_; }
  void write_case(const nlohmann::json& definition) const;

  /// Runs to its end. `prelude`: a shell command that each rank begins with.
  Ended run(int ranks, const std::string& options = "", const std::string& prelude = "true") const;

  /// Starts mpirun, returns its process id.
  pid_t start(int ranks, const std::string& options = "");
  /// Waits until status.json says that this step has been made; false after 60 s or when mpirun ends before.
  bool wait_for_step(std::int64_t step) const;
  /// Waits for what start() began.
  Ended wait();

  [[nodiscard]] nlohmann::json summary() const;
  [[nodiscard]] std::filesystem::path newest_checkpoint() const;

 private:
  [[nodiscard]] std::string command(int ranks, const std::string& options,
                                    const std::string& prelude = "true") const;
  RunFiles files_;
  pid_t mpirun_ = -1;
};

/// A small case with statistics, 0.01 per step, which ends after so many steps.
[[nodiscard]] nlohmann::json rigid_case(int steps);
[[nodiscard]] nlohmann::json elastic_case(int steps);
[[nodiscard]] nlohmann::json reference_map_case(int steps);
/// A wave at the interface of that layer, in two dimensions.
[[nodiscard]] nlohmann::json wave_case(int steps);
/// The same over laminar flow.
[[nodiscard]] nlohmann::json driven_wave_case(int steps);

/// The same case with planes of its flow every so many h / U_b.
[[nodiscard]] nlohmann::json filmed(nlohmann::json definition, double interval);

[[nodiscard]] std::string contents(const std::filesystem::path& file);

/// Of the files in a folder.
[[nodiscard]] std::set<std::string> names_in(const std::filesystem::path& folder);

/// All bytes behind a checkpoint's header: state, statistics and diagnostics.
[[nodiscard]] std::string checkpoint_data(const std::filesystem::path& file);

/// Flips one bit in the middle of a file.
void damage(const std::filesystem::path& file);

/// Final checkpoint and statistics of two runs are the same, bit for bit.
void expect_same_results(const SolverRun& a, const SolverRun& b);

/// So are all files of their films, which have so many moments.
void expect_same_film(const SolverRun& a, const SolverRun& b, std::size_t moments);

}  // namespace softwall::support
