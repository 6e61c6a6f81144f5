#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <utility>

#include "campaign/observe/observe.hpp"
#include "campaign/runner/runner.hpp"
#include "solver/run_directory/exit_codes.hpp"
#include "solver/run_directory/statistics_file.hpp"
#include "solver/run_directory/status.hpp"
#include "tests/analysis/samples.hpp"
#include "tests/campaign/core/examples.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/campaign/runner/fake_launcher.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {

inline constexpr int kDone = static_cast<int>(ExitCode::kDone);

/// A precursor and four elastic cases on two cores, with everything real but the processes.
class RunnerTest : public ::testing::Test {
 protected:
  RunnerTest() {
    auto document = tests::elastic_campaign();
    document["execution"] = {{"ranks", 1}, {"precursor_ranks", 2}, {"cores", 2}};
    campaign_ = tests::campaign_of(document);
  }

  [[nodiscard]] const CampaignCase& case_of(const std::string& id) const {
    return *std::ranges::find_if(campaign_.cases, [&](const auto& one) { return one.definition.id == id; });
  }

  /// What a solver leaves that reaches the end.
  int finish(const LaunchRequest& request) const {
    const RunFiles run{request.run_directory};
    const double end_time = case_of(request.case_id).definition.run.end_time;
    test::write_checkpoint(run, request.case_id, 1000, end_time);
    auto statistics = analysis::samples::elastic_statistics({}, 20);
    statistics.case_id = request.case_id;
    analysis::write_statistics(run.statistics(), statistics);
    test::write_summary(run, request.case_id, request.attempt, "finished", 1000, end_time);
    return kDone;
  }

  /// What one leaves that diverges before its first checkpoint.
  static int diverge(const LaunchRequest& request) {
    test::write_summary(RunFiles{request.run_directory}, request.case_id, request.attempt, "diverged", 5,
                        0.1);
    return static_cast<int>(ExitCode::kDiverged);
  }

  /// What a solver leaves at a checkpoint and goes on.
  static void write_so_far(const LaunchRequest& request, std::int64_t step, double time,
                           analysis::BlockStatistics statistics) {
    const RunFiles run{request.run_directory};
    test::write_checkpoint(run, request.case_id, step, time);
    statistics.case_id = request.case_id;
    analysis::write_statistics(run.statistics(), statistics);
    Status status;
    status.case_id = request.case_id;
    status.attempt = request.attempt;
    status.step = status.checkpoint_step = step;
    std::ofstream(run.status()) << nlohmann::json(status).dump();
  }

  RunnerReport run(Launcher& launcher, RunnerOptions options = {}) {
    options.poll = options.patient_poll = std::chrono::milliseconds(1);
    Signals signals;
    Progress progress("");
    Store store = Store::open(folder_.path(), OpenMode::kCreate);
    return Runner(campaign_, folder_.path(), {launcher, store, progress, signals}, options).run();
  }

  [[nodiscard]] Store store() const { return Store::open(folder_.path(), OpenMode::kReadOnly); }
  [[nodiscard]] const std::string& id(std::size_t i) const { return campaign_.cases.at(i).definition.id; }

  test::TemporaryFolder folder_;
  Campaign campaign_;
};

}  // namespace softwall::campaign
