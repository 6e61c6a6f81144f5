#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "solver/output/checkpoint_reader.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "tests/restart/solver_run.hpp"

// A run that was stopped for any reason and resumed gives, on the same number of ranks, the same bits as one
// that was not; on another number of ranks the same numbers to round-off.
namespace softwall::support {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

struct Setting {
  const char* flow;
  int ranks;
  friend std::ostream& operator<<(std::ostream& out, const Setting& setting) {
    return out << setting.flow << " on " << setting.ranks;
  }
};

class Restart : public testing::TestWithParam<Setting> {
 protected:
  [[nodiscard]] int ranks() const { return GetParam().ranks; }
  [[nodiscard]] static json a_case(int steps) {
    const std::string flow = GetParam().flow;
    if (flow == "rigid") return rigid_case(steps);
    if (flow == "reference_map") return reference_map_case(steps);
    if (flow == "wave") return wave_case(steps);
    if (flow == "driven_wave") return driven_wave_case(steps);
    json c = elastic_case(steps);
    if (flow == "single") c["physics"]["precision"] = "single";
    return c;
  }
  /// Never stopped.
  [[nodiscard]] std::unique_ptr<SolverRun> reference(int steps) const {
    auto run = std::make_unique<SolverRun>(a_case(steps));
    const Ended ended = run->run(ranks());
    EXPECT_EQ(ended.code, 0) << ended.output;
    return run;
  }
};

INSTANTIATE_TEST_SUITE_P(, Restart,
                         testing::Values(Setting{"rigid", 1}, Setting{"rigid", 2}, Setting{"rigid", 4},
                                         Setting{"elastic", 1}, Setting{"elastic", 2}, Setting{"elastic", 4},
                                         Setting{"single", 2}, Setting{"reference_map", 1},
                                         Setting{"reference_map", 2}, Setting{"reference_map", 4},
                                         Setting{"wave", 1}, Setting{"wave", 2}, Setting{"driven_wave", 2}),
                         [](const auto& test) { return test.param.flow + std::to_string(test.param.ranks); });

TEST_P(Restart, FromEachCheckpointOfAnInterval) {
  const auto whole = reference(25);
  json definition = a_case(25);
  definition["run"]["checkpoint_steps"] = 4;
  definition["run"]["keep_checkpoints"] = 100;
  const SolverRun source(definition);
  ASSERT_EQ(source.run(ranks()).code, 0);
  expect_same_results(source, *whole);
  for (const int step : {4, 16}) {
    const SolverRun resumed(definition);
    fs::create_directories(resumed.files().checkpoints());
    fs::copy_file(source.files().checkpoint(step), resumed.files().checkpoint(step));
    const Ended ended = resumed.run(ranks());
    ASSERT_EQ(ended.code, 0) << ended.output;
    EXPECT_NE(ended.output.find("step " + std::to_string(step)), std::string::npos) << ended.output;
    EXPECT_EQ(resumed.summary().at("attempt_steps"), 25 - step);
    expect_same_results(resumed, *whole);
  }
}

TEST_P(Restart, FromTheEndWhenTheEndIsMoved) {
  const SolverRun whole(filmed(a_case(25), 0.03));
  ASSERT_EQ(whole.run(ranks()).code, 0);
  const SolverRun run(filmed(a_case(11), 0.03));
  ASSERT_EQ(run.run(ranks()).code, 0);
  run.write_case(filmed(a_case(25), 0.03));
  const Ended ended = run.run(ranks());
  ASSERT_EQ(ended.code, 0) << ended.output;
  expect_same_results(run, whole);
  expect_same_film(run, whole, 9);  // t = 0, 0.03 ... 0.24
}

TEST_P(Restart, AfterASignal) {
  // A wave has one cell in z: long enough for the signal to come in time on a busy machine.
  const int steps = std::string(GetParam().flow).ends_with("wave") ? 2000 : 300;
  const auto whole = reference(steps);
  SolverRun run(a_case(steps));
  const pid_t mpirun = run.start(ranks());
  ASSERT_TRUE(run.wait_for_step(0));
  ASSERT_EQ(::kill(mpirun, SIGUSR1), 0);
  const Ended stopped = run.wait();
  ASSERT_EQ(stopped.code, 85) << stopped.output;
  EXPECT_EQ(run.summary().at("outcome"), "interrupted");
  EXPECT_EQ(run.summary().at("checkpoint"), "checkpoints/" + run.newest_checkpoint().filename().string());
  const Ended ended = run.run(ranks());
  ASSERT_EQ(ended.code, 0) << ended.output;
  EXPECT_LT(run.summary().at("attempt_steps"), steps + 1);
  expect_same_results(run, *whole);
}

TEST_P(Restart, AfterTheWallClockLimitBeforeTheFirstStep) {
  const auto whole = reference(12);
  const SolverRun run(a_case(12));
  const Ended stopped = run.run(ranks(), "--wall-seconds 0.001");
  ASSERT_EQ(stopped.code, 85) << stopped.output;
  EXPECT_EQ(run.summary().at("reason"), "wall-clock limit");
  EXPECT_EQ(run.summary().at("step"), 0);
  ASSERT_EQ(run.run(ranks()).code, 0);
  expect_same_results(run, *whole);
}

TEST_P(Restart, AfterKillsAtAnyMoment) {
  constexpr int kSteps = 200;
  json definition = filmed(a_case(kSteps), 0.2);
  const SolverRun whole(definition);
  ASSERT_EQ(whole.run(ranks()).code, 0);
  definition["run"]["checkpoint_steps"] = 7;
  SolverRun run(definition);
  for (const int delay : {0, 60, 150}) {  // ms after the solver has come up
    fs::remove(run.files().status());
    const pid_t mpirun = run.start(ranks());
    const bool alive = run.wait_for_step(0);
    std::this_thread::sleep_for(std::chrono::milliseconds(delay));
    ::kill(mpirun, SIGKILL);
    static_cast<void>(run.wait());
    if (!alive) break;
  }
  const Ended ended = run.run(ranks());  // waits for the ranks of the killed mpirun to leave the lock
  ASSERT_EQ(ended.code, 0) << ended.output;
  expect_same_results(run, whole);
  expect_same_film(run, whole, 11);  // t = 0, 0.2 ... 2
}

/// The driving gradient of the last step, which the next step's length follows, is in the checkpoint.
TEST(RestartOfAdaptiveSteps, TakesTheSameOnesWhereAccuracyLimitsThem) {
  const auto adaptive = [](int steps) {
    json c = reference_map_case(steps);
    c["physics"]["time_step"].erase("fixed_dt");
    c["physics"]["solid"]["dt_plus"] = 0.02;
    return c;
  };
  const SolverRun whole(adaptive(40)), stopped(adaptive(20));
  ASSERT_EQ(whole.run(2).code, 0);
  EXPECT_EQ(json::parse(contents(whole.files().status())).at("dt_limit"), "accuracy");
  ASSERT_EQ(stopped.run(2).code, 0);
  const auto first = stopped.summary().at("step");
  stopped.write_case(adaptive(40));
  ASSERT_EQ(stopped.run(2).code, 0);
  EXPECT_GT(stopped.summary().at("step"), first);
  expect_same_results(stopped, whole);
}

/// Largest difference of a field between two checkpoints of one grid.
double difference(const fs::path& a, const fs::path& b, const std::string& field) {
  const output::CheckpointFile first(a), second(b);
  const auto [nz, rows, nx] = first.extents(field);
  static_cast<void>(rows);
  const auto x = first.columns(field, {0, nx, 0, nz}), y = second.columns(field, {0, nx, 0, nz});
  double top = 0;
  for (std::size_t n = 0; n < x.size(); ++n) top = std::fmax(top, std::abs(x[n] - y[n]));
  return top;
}

void expect_same_numbers_on_other_ranks(json (*a_case)(int), const std::vector<const char*>& fields) {
  const SolverRun whole(a_case(30));
  ASSERT_EQ(whole.run(2).code, 0);
  for (const int other : {1, 4}) {
    const SolverRun run(a_case(15));
    ASSERT_EQ(run.run(2).code, 0);
    run.write_case(a_case(30));
    ASSERT_EQ(run.run(other).code, 0);
    ASSERT_EQ(run.newest_checkpoint().filename(), whole.newest_checkpoint().filename());
    for (const char* field : fields) {
      EXPECT_LT(difference(run.newest_checkpoint(), whole.newest_checkpoint(), field), 1e-11) << field;
    }
  }
}

TEST(RestartOnOtherRanks, GivesTheSameNumbersToRoundOff) {
  expect_same_numbers_on_other_ranks(
      elastic_case, {"fields/u", "fields/v", "fields/w", "fields/p", "fields/phi", "fields/B_xy"});
  for (const auto a_case : {reference_map_case, wave_case}) {
    expect_same_numbers_on_other_ranks(
        a_case, {"fields/u", "fields/v", "fields/w", "fields/p", "fields/d_x", "fields/d_y", "fields/d_z"});
  }
}

/// An attempt got further than its last checkpoint; on other ranks its steps need not end at the same times.
TEST(RestartOnOtherRanks, LeavesNoMomentOfTheLostTrajectory) {
  const SolverRun whole(filmed(rigid_case(25), 0.03));
  ASSERT_EQ(whole.run(2).code, 0);
  const SolverRun run(filmed(rigid_case(13), 0.03));
  ASSERT_EQ(run.run(2).code, 0);
  fs::copy_file(whole.files().planes_of(15), run.files().planes_of(14));
  run.write_case(filmed(rigid_case(25), 0.03));
  ASSERT_EQ(run.run(1).code, 0);
  const std::set<std::string> names = names_in(run.files().planes());
  EXPECT_EQ(names, names_in(whole.files().planes()));
}

}  // namespace
}  // namespace softwall::support
