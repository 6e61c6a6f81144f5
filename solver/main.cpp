#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "solver/case/option_number.hpp"
#include "solver/case/standard_streams.hpp"
#include "solver/right_program.hpp"
#include "solver/run_directory/build_info.hpp"
#include "solver/simulation.hpp"
#include "solver/stop_request.hpp"

// softwall-dns: runs one case under mpirun. See solver/run_directory/exit_codes.hpp for what it returns.

namespace {

softwall::RunOptions parse(CLI::App& app, int argc, char** argv) {
  softwall::RunOptions options;
  const softwall::BuildInfo build = softwall::build_info();
  app.set_version_flag("--version", "softwall-dns " + build.version + " (" + build.git_revision + ")");
  app.add_option("RUN_DIR", options.files.directory, "folder that holds case.json")->required();
  const auto within = [](softwall::OptionRange range) {
    return CLI::Validator([range](const std::string& text) { return trouble_with_number(text, range); }, "");
  };
  app.add_option("--attempt", options.attempt, "number of this attempt, for the reports")
      ->check(within({.high = 1e9}));
  app.add_option("--wall-seconds", options.wall_seconds,
                 "stop in order before so many seconds have passed; 0: no limit")
      ->check(within({.high = 1e9}));
  app.add_flag("--snapshot", options.snapshot,
               "write a snapshot of the newest checkpoint into fields/, and compute nothing");
  app.add_flag("--profile", options.profile, "say at the end where the time went and what was sent");
  app.parse(argc, argv);
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  softwall::open_standard_streams();
  softwall::install_signal_handlers();
  CLI::App app("Direct numerical simulation of channel flow over a rigid or an elastic wall");
  softwall::RunOptions options;
  try {
    options = parse(app, argc, argv);
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) != 0) return static_cast<int>(softwall::ExitCode::kBadCase);
    return std::cout << std::flush ? 0 : static_cast<int>(softwall::ExitCode::kFailed);  // help or version
  }
  softwall::become_right_program(options.files, argv);
  const softwall::parallel::Session mpi(&argc, &argv);
  try {
    return static_cast<int>(softwall::run_case(options, MPI_COMM_WORLD));
  } catch (const std::exception& error) {
    // One rank's own trouble: the others would wait for it for ever.
    std::fprintf(stderr, "softwall-dns: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(softwall::ExitCode::kFailed));
    return static_cast<int>(softwall::ExitCode::kFailed);
  }
}
