#include "campaign/observe/left_over.hpp"

#include <gtest/gtest.h>

#include <set>

#include "campaign/observe/history.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/removed_directories.hpp"
#include "campaign/observe/run_directory.hpp"
#include "tests/campaign/core/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

/// A campaign whose run directories are there, and what may follow it in the same folder.
class LeftOverTest : public ::testing::Test {
 protected:
  LeftOverTest() { prepare(document_); }
  void prepare(const nlohmann::json& document) {
    for (const CampaignCase& one : loaded(document).cases)
      prepare_run_directory(one.definition, run_files(folder_.path(), one), {});
  }
  [[nodiscard]] Campaign loaded(const nlohmann::json& document) const {
    Campaign campaign = tests::campaign_of(document);
    keep_existing_directories(campaign, folder_.path(), existing_directories(folder_.path()));
    return campaign;
  }
  [[nodiscard]] std::string labels(const nlohmann::json& document) const {
    std::string text;
    for (const auto& one : loaded(document).cases) text += (text.empty() ? "" : " ") + one.definition.label;
    return text;
  }

  nlohmann::json document_ = tests::elastic_campaign();
  softwall::test::TemporaryFolder folder_;
};

TEST_F(LeftOverTest, NothingIsLeftOverFromTheSameCampaign) {
  EXPECT_TRUE(left_over_cases(loaded(document_), folder_.path()).empty());
}

TEST_F(LeftOverTest, CasesThatLeftTheSweepAreFoundWithTheirPrecursor) {
  auto other = document_;
  other["physics"]["reynolds"] = 3000;
  const Campaign now = loaded(other);
  const auto left = left_over_cases(now, folder_.path());
  ASSERT_EQ(left.size(), 5U);
  EXPECT_TRUE(left[0].is_precursor);
  EXPECT_EQ(left[0].definition.label, "precursor");
  for (std::size_t i = 1; i < left.size(); ++i) EXPECT_FALSE(left[i].is_precursor);
  EXPECT_EQ(why_left_over(left[0], now), "like precursor, but reynolds 2800 instead of 3000");
  EXPECT_NE(why_left_over(left[1], now).find("another precursor"), std::string::npos);
}

/// Cases of an attempt at other steps or blocks lie beside the finished ones when the sweep grows.
TEST_F(LeftOverTest, AbandonedVariantsDisplaceNoCaseOfTheCampaign) {
  auto other_steps = document_, other_blocks = document_, longer_sweep = document_;
  other_steps["physics"]["solid"]["dt_plus"] = 0.2;
  other_blocks["physics"]["statistics"]["block_length"] = 0.5;
  longer_sweep["sweep"]["grid"]["G"].push_back(4.5);
  prepare(other_steps);
  prepare(other_blocks);
  const Campaign before = tests::campaign_of(document_), alone = tests::campaign_of(longer_sweep);
  const ExistingCases existing = existing_cases(alone, folder_.path(), existing_directories(folder_.path()));
  std::set<std::string> ids;
  for (const auto& one : parse_campaign(longer_sweep.dump(), "campaign", existing).cases)
    ids.insert(one.definition.id);
  for (const auto& one : before.cases) EXPECT_TRUE(ids.contains(one.definition.id)) << one.definition.label;
  EXPECT_GT(ids.size(), before.cases.size());
}

/// A case that started others of the sweep is no precursor, and its end time is a part of them.
TEST_F(LeftOverTest, ARaisedEndMakesOtherCasesOfThoseThatStartFromOthers) {
  document_["start_from"] = {{"nearest", "G"}};
  auto longer = document_;
  longer["run"]["end_time"] = 60;
  prepare(document_);
  const Campaign now = loaded(longer);
  int of_the_line = 0;
  for (const auto& one : left_over_cases(now, folder_.path())) {
    EXPECT_FALSE(one.is_precursor) << one.definition.label;
    if (one.definition.physics.initial.type != InitialType::kNeighbour) continue;
    ++of_the_line;
    EXPECT_NE(why_left_over(one, now).find(", but initial.precursor_time 50 instead of 60"),
              std::string::npos)
        << why_left_over(one, now);
  }
  EXPECT_EQ(of_the_line, 2);
}

TEST_F(LeftOverTest, ARaisedEndOfThePrecursorIsNamed) {
  auto other = document_;
  other["precursor"]["run"]["end_time"] = 120;
  const Campaign now = loaded(other);
  const auto left = left_over_cases(now, folder_.path());
  ASSERT_EQ(left.size(), 4U);  // the precursor goes on
  EXPECT_EQ(why_left_over(left[0], now),
            "like " + left[0].definition.label + ", but initial.precursor_time 100 instead of 120");
}

TEST_F(LeftOverTest, ADirectoryWithoutACaseIsNone) {
  folder_.write("cases/notes-01234567/case.json", "{");
  folder_.write("cases/readme", "");
  EXPECT_TRUE(left_over_cases(loaded(document_), folder_.path()).empty());
  EXPECT_EQ(directories_without_a_case(loaded(document_), folder_.path()),
            std::vector<std::string>{"cases/notes-01234567"});
}

/// A softwall that is killed while it removes a case leaves a part of it, maybe with its case file.
TEST_F(LeftOverTest, ADirectoryThatIsBeingRemovedIsNoCase) {
  const std::string directory = loaded(document_).cases.back().directory;
  const auto was = folder_.path() / directory;
  const auto doomed = was.parent_path() / (".removed-" + was.filename().string());
  std::filesystem::rename(was, doomed);
  EXPECT_TRUE(left_over_cases(loaded(document_), folder_.path()).empty());
  EXPECT_TRUE(directories_without_a_case(loaded(document_), folder_.path()).empty());
  EXPECT_EQ(loaded(document_).cases.back().directory, directory);
  EXPECT_EQ(unfinished_removals(folder_.path()), std::vector{doomed});
  prepare(document_);
  remove_run_directory(was);
  EXPECT_FALSE(std::filesystem::exists(was));
  EXPECT_TRUE(unfinished_removals(folder_.path()).empty());
}

TEST_F(LeftOverTest, ACaseKeepsTheLabelItWasRunUnder) {
  EXPECT_EQ(labels(document_), "precursor G=1_mu=0.1 G=1_mu=1 G=2_mu=0.1 G=2_mu=1");
  auto smaller = document_;
  smaller["sweep"] =
      nlohmann::json::parse(R"({"grid": {"G": [1, 2, 3]}})");  // mu is 1 now, and varies no more
  EXPECT_EQ(labels(smaller), "precursor G=1_mu=1 G=2_mu=1 G=3");
  for (const auto& one : loaded(smaller).cases)
    EXPECT_EQ(one.directory, "cases/" + one.definition.label + "-" + one.definition.id.substr(0, 8));
}

TEST_F(LeftOverTest, ADirectoryOfAnotherCaseIsNotTakenForItsDigits) {
  const CampaignCase one = loaded(document_).cases.back();
  const auto mine = folder_.path() / one.directory;
  const auto other = folder_.path() / ("cases/other-" + one.definition.id.substr(0, 8));
  std::filesystem::rename(mine, other);
  EXPECT_EQ(loaded(document_).cases.back().definition.label, "other");  // moved, but its own
  std::filesystem::copy_file(run_files(folder_.path(), loaded(document_).cases.front()).case_file(),
                             other / "case.json", std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(loaded(document_).cases.back().definition.label, one.definition.label);
}

TEST(History, IsReadAsItWasWritten) {
  const softwall::test::TemporaryFolder folder;
  const RunFiles run{folder.path()};
  EXPECT_TRUE(read_history(run, "0123456789abcdef").empty());
  PastAttempt first, second;
  first.attempt = 1;
  first.start = {"here", 2, ""};
  first.end.outcome = AttemptOutcome::kIoFailure;
  first.end.reason = "disk \xff full";
  second.attempt = 2;
  second.start = {"there", 1, "checkpoints/checkpoint-000000010.h5"};
  second.end.outcome = AttemptOutcome::kFinished;
  second.end.exit_code = 0;
  second.end.step = 20;
  second.end.time = 0.1 + 0.2;
  second.end.wall_seconds = 1.5;
  second.end.started = "2026-01-01T00:00:00.000Z";
  second.end.diagnostics = {{"divergence", 1e-15}};
  write_history(run, "0123456789abcdef", {first, second});
  const auto read = read_history(run, "0123456789abcdef");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].end.outcome, AttemptOutcome::kIoFailure);
  EXPECT_FALSE(read[0].end.step.has_value());
  EXPECT_EQ(read[1].start.resumed_from, second.start.resumed_from);
  EXPECT_EQ(read[1].end.time, 0.1 + 0.2);
  EXPECT_EQ(read[1].end.diagnostics, second.end.diagnostics);
  EXPECT_TRUE(read_history(run, "another").empty());
  folder.write("history.json",
               R"({"format": 1, "case_id": "0123456789abcdef", "attempts": [{"attempt": "x"}]})");
  EXPECT_TRUE(read_history(run, "0123456789abcdef").empty());
}

}  // namespace
}  // namespace softwall::campaign
