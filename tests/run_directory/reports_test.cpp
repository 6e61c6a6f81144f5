#include <gtest/gtest.h>

#include <limits>

#include "schemas/embedded.hpp"
#include "solver/case/json_schema.hpp"
#include "solver/run_directory/run_record.hpp"
#include "solver/run_directory/status.hpp"
#include "solver/run_directory/summary.hpp"

namespace softwall {
namespace {

using nlohmann::json;

constexpr const char* kReportedId = "0123456789abcdef";

Status some_status() {
  return {.case_id = kReportedId,
          .attempt = 2,
          .ranks = 4,
          .pid = 77,
          .host = "node",
          .step = 10,
          .time = 0.5,
          .end_time = 9,
          .dt = 0.05,
          .dt_limit = "elastic",
          .seconds_per_step = 0.25,
          .checkpoint_step = 8,
          .updated = 1.5e9,
          .wall_seconds = 12.5};
}

Summary some_summary() {
  Summary s;
  s.case_id = kReportedId;
  s.attempt = 3;
  s.outcome = outcome_of(ExitCode::kInterrupted);
  s.reason = "asked to";
  s.exit_code = static_cast<int>(ExitCode::kInterrupted);
  s.step = 20;
  s.time = 1;
  s.end_time = 2;
  s.attempt_steps = 10;
  s.wall_seconds = 3.5;
  s.ns_per_cell_step = 250;
  s.checkpoint = "checkpoints/checkpoint-000000020.h5";
  s.diagnostics = {{"divergence", 1e-15}};
  s.version = "1.2.3";
  s.git_revision = "abc";
  s.build_type = "Release";
  s.compiler = "GNU";
  s.host = "node";
  s.ranks = 4;
  s.started = "2026-01-01T00:00:00.000Z";
  s.ended = "2026-01-01T00:00:01.000Z";
  return s;
}

/// What is written is what the schema describes, every required member included, and comes back as it was.
template <class Report>
void expect_agreement(const Report& report, std::string_view schema) {
  const json written = report, described = json::parse(schema);
  EXPECT_EQ(JsonSchema(schema).mistakes(written).size(), 0U) << written;
  for (const std::string name : described.at("required")) EXPECT_TRUE(written.contains(name)) << name;
  for (const auto& [name, unused] : written.items()) {
    EXPECT_TRUE(described.at("properties").contains(name)) << name << " is not in the schema";
  }
  EXPECT_EQ(json(written.template get<Report>()), written);
}

TEST(Reports, AgreeWithTheirSchemasInBothDirections) {
  expect_agreement(some_status(), schemas::kStatusSchema);
  expect_agreement(some_summary(), schemas::kSummarySchema);
  expect_agreement(RunRecord{kReportedId, 1, "a handle", "node", "2026-01-01T00:00:00.000Z"},
                   schemas::kRunSchema);
}

TEST(Reports, WhatIsNotFiniteStaysValid) {
  Summary s = some_summary();
  s.time = std::numeric_limits<double>::infinity();
  s.diagnostics["kinetic_energy"] = std::numeric_limits<double>::quiet_NaN();
  const json written = s;
  EXPECT_TRUE(JsonSchema(schemas::kSummarySchema).mistakes(written).empty()) << written;
  EXPECT_EQ(written.at("time"), 0.0);
  EXPECT_TRUE(written.at("diagnostics").at("kinetic_energy").is_null());
  EXPECT_FALSE(written.get<Summary>().diagnostics.contains("kinetic_energy"));
}

TEST(Reports, ExitStatusesHaveTheirWords) {
  EXPECT_EQ(outcome_of(ExitCode::kDone), "finished");
  EXPECT_EQ(outcome_of(ExitCode::kDiverged), "diverged");
  for (const ExitCode code : {ExitCode::kFailed, ExitCode::kBadCase, ExitCode::kIoFailure}) {
    EXPECT_EQ(outcome_of(code), "failed");
  }
}

}  // namespace
}  // namespace softwall
