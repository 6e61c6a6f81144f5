#include "campaign/store/store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "campaign/core/words.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {
namespace {

using ::testing::HasSubstr;

class StoreTest : public ::testing::Test {
 protected:
  void SetUp() override { store.record_campaign(campaign); }

  test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  Campaign campaign = paper_campaign();
  std::string id = case_with(campaign, 1.0, 1.0).definition.id;

  AttemptStart start{"here", 2, ""};
  void attempt_that_ends_with(const AttemptEnd& end) {
    store.end_attempt(id, store.begin_attempt(id, start), end);
  }
  void attempt_that_ends_with(AttemptOutcome outcome, std::int64_t step) {
    AttemptEnd end = failed_at(step);
    end.outcome = outcome;
    attempt_that_ends_with(end);
  }
  [[nodiscard]] int attempts_without_progress(const std::string& of) const {
    return store.find_case(of)->attempts_without_progress;
  }
};

TEST_F(StoreTest, KnowsTheCampaignAndItsCasesPrecursorFirst) {
  EXPECT_EQ(answer(store, "SELECT name FROM campaign"), "walls");
  EXPECT_EQ(answer(store, "SELECT spec FROM campaign"), campaign.spec_text);
  EXPECT_EQ(answer(store, "SELECT count(*) FROM cases WHERE state = 'new'"), "7");
  EXPECT_EQ(answer(store, "SELECT is_precursor FROM cases ORDER BY rowid LIMIT 1"), "1");
  EXPECT_EQ(store.find_case(id)->attempts, 0);
  EXPECT_EQ(answer(store, "SELECT count(*) FROM cases WHERE G IS NULL AND viscosity_ratio IS NULL"), "1");
  EXPECT_EQ(answer(store, "SELECT grid FROM cases WHERE case_id = '" + id + "'"), "48x64+16x48");
  EXPECT_EQ(answer(store, "SELECT cells FROM cases WHERE case_id = '" + id + "'"),
            std::to_string(48 * 80 * 48));
  EXPECT_EQ(answer(store, "SELECT count(*) FROM cases e JOIN cases p ON p.case_id = e.precursor_id"), "6");
}

TEST_F(StoreTest, RecordingTheCampaignAgainKeepsWhatIsKnown) {
  attempt_that_ends_with(AttemptOutcome::kInterrupted, 10);
  store.set_state(id, CaseState::kInterrupted, "asked to");
  store.record_result(id, result_made_of(100.0), "abc");
  store.record_campaign(campaign);
  EXPECT_EQ(answer(store, "SELECT count(*) FROM cases"), "7");
  EXPECT_EQ(store.find_case(id)->state, CaseState::kInterrupted);
  EXPECT_EQ(store.find_case(id)->state_reason, "asked to");
  EXPECT_EQ(store.attempts(id), 1);
  EXPECT_TRUE(store.result_origin(id).has_value());
}

TEST_F(StoreTest, ASmallerSweepForgetsNothing) {
  campaign.cases.pop_back();
  store.record_campaign(campaign);
  EXPECT_EQ(answer(store, "SELECT count(*) FROM results_all"), "7");
  EXPECT_EQ(answer(store, "SELECT count(*) FROM results_all WHERE in_campaign = 0"), "1");
}

TEST_F(StoreTest, RemembersEveryState) {
  for (const CaseState state : {CaseState::kRunning, CaseState::kFinished, CaseState::kInterrupted,
                                CaseState::kDiverged, CaseState::kFailed, CaseState::kNew}) {
    store.set_state(id, state, "because");
    EXPECT_EQ(store.find_case(id)->state, state);
  }
}

TEST_F(StoreTest, WhatAnotherVersionHasComputedIsStale) {
  const auto attempt_of = [&](const std::string& version) {
    AttemptEnd end = failed_at(10);
    end.version = version;
    store.end_attempt(id, store.begin_attempt(id, start), end);
  };
  attempt_of("0.2.0");
  store.mark_stale("0.2.0");
  EXPECT_EQ(answer(store, "SELECT sum(stale) FROM cases"), "0");
  store.mark_stale("0.3.0");
  EXPECT_EQ(store.find_case(id)->stale_reason, "computed by version 0.2.0, this is 0.3.0");
  EXPECT_EQ(answer(store, "SELECT sum(stale) FROM cases"), "1");
  attempt_of("0.3.0");  // goes on from what the older one had computed
  store.mark_stale("0.3.0");
  EXPECT_EQ(store.find_case(id)->stale_reason, "computed by version 0.2.0, this is 0.3.0");
  store.mark_stale("0.2.0");
  EXPECT_EQ(store.find_case(id)->stale_reason, "computed by version 0.3.0, this is 0.2.0");
}

TEST_F(StoreTest, RefusesWordsAboutWhatItDoesNotHave) {
  EXPECT_THAT(refusal([&] { store.set_state("nobody", CaseState::kFailed, ""); }),
              HasSubstr("no case nobody"));
  EXPECT_THAT(refusal([&] { (void)store.begin_attempt("nobody", start); }), HasSubstr("no case nobody"));
  EXPECT_THAT(refusal([&] { store.end_attempt(id, 7, {}); }), HasSubstr("no attempt 7 of case " + id));
  EXPECT_THAT(refusal([&] { store.attempt_started(id, 7, "7"); }), HasSubstr("no attempt 7"));
  EXPECT_THAT(refusal([&] { store.forgive("nobody"); }), HasSubstr("no case nobody"));
  EXPECT_THAT(refusal([&] { store.record_result("nobody", result_made_of(1.0), ""); }),
              HasSubstr("FOREIGN KEY"));
  EXPECT_FALSE(store.find_case("nobody").has_value());
}

TEST_F(StoreTest, AnAttemptIsKnownFromItsIntentToItsEnd) {
  EXPECT_EQ(store.begin_attempt(id, start), 1);
  EXPECT_EQ(store.find_case(id)->state, CaseState::kRunning);
  ASSERT_EQ(store.open_attempts(id).size(), 1U);
  EXPECT_EQ(answer(store, "SELECT started IS NULL AND handle IS NULL FROM attempts"), "1");

  store.attempt_started(id, 1, "job 4711");
  EXPECT_EQ(answer(store, "SELECT handle FROM attempts WHERE started IS NOT NULL"), "job 4711");

  AttemptEnd end;
  end.outcome = AttemptOutcome::kInterrupted;
  end.reason = "asked to";
  end.exit_code = 85;
  end.step = 120;
  end.time = 0.5;
  end.wall_seconds = 12.5;
  end.ns_per_cell_step = 250.0;
  end.git_revision = "abc123";
  end.diagnostics = {{"max_divergence", 1e-14}, {"nan", std::nan("")}};
  store.end_attempt(id, 1, end);
  EXPECT_TRUE(store.open_attempts(id).empty());
  EXPECT_EQ(answer(store,
                   "SELECT outcome || ', ' || reason || ', ' || exit_code || ', ' || step || ', ' || time || "
                   "', ' || wall_seconds FROM attempts"),
            "interrupted, asked to, 85, 120, 0.5, 12.5");
  EXPECT_EQ(answer(store, "SELECT git_revision FROM attempts"), "abc123");
  EXPECT_EQ(answer(store, "SELECT compiler IS NULL FROM attempts"), "1");
  EXPECT_EQ(answer(store, "SELECT value FROM diagnostics WHERE name = 'max_divergence'"), "1.0e-14");
  EXPECT_EQ(answer(store, "SELECT value IS NULL FROM diagnostics WHERE name = 'nan'"), "1");
  EXPECT_EQ(store.begin_attempt(id, start), 2);
}

TEST_F(StoreTest, WhereAnAttemptRanAndBeganIsWhatItSaysItself) {
  AttemptEnd end = failed_at(5);
  store.end_attempt(id, store.begin_attempt(id, {"login", 4, "checkpoints/a.h5"}), end);
  EXPECT_EQ(answer(store, "SELECT host || ranks || resumed_from FROM attempts"), "login4checkpoints/a.h5");
  end.began = AttemptStart{"node7", 2, "checkpoints/b.h5"};
  store.end_attempt(id, 1, end);
  EXPECT_EQ(answer(store, "SELECT host || ranks || resumed_from FROM attempts"), "node72checkpoints/b.h5");
}

TEST_F(StoreTest, EndingTwiceIsEndingOnce) {
  const int attempt = store.begin_attempt(id, start);
  AttemptEnd end = failed_at(5);
  end.diagnostics = {{"a", 1.0}, {"b", 2.0}};
  store.end_attempt(id, attempt, end);
  end.diagnostics.erase("b");
  store.end_attempt(id, attempt, end);
  EXPECT_EQ(answer(store, "SELECT count(*) FROM attempts"), "1");
  EXPECT_EQ(answer(store, "SELECT group_concat(name) FROM diagnostics"), "a");
}

TEST_F(StoreTest, AttemptsOfALostStoreAreRestoredOnce) {
  AttemptEnd end = failed_at(9);
  end.started = "2024-01-01T00:00:00Z";
  end.ended = "2024-01-01T01:00:00Z";
  store.restore_attempt(id, 3, start, end);
  store.restore_attempt(id, 3, start, end);
  EXPECT_EQ(
      answer(
          store,
          "SELECT group_concat(attempt || ' ' || intended || ' ' || started || ' ' || ended) FROM attempts"),
      "3 2024-01-01T00:00:00Z 2024-01-01T00:00:00Z 2024-01-01T01:00:00Z");
  EXPECT_EQ(store.begin_attempt(id, start), 4);
}

TEST_F(StoreTest, CountsFailuresSinceTheLastProgress) {
  EXPECT_EQ(attempts_without_progress(id), 0);
  attempt_that_ends_with(failed_at(0));
  EXPECT_EQ(attempts_without_progress(id), 1);
  attempt_that_ends_with(failed_at(100));
  EXPECT_EQ(attempts_without_progress(id), 0);
  attempt_that_ends_with(failed_at(100));
  attempt_that_ends_with(failed_at(60));
  EXPECT_EQ(attempts_without_progress(id), 2);
  (void)store.begin_attempt(id, start);  // running: no failure yet
  EXPECT_EQ(attempts_without_progress(id), 2);
  store.end_attempt(id, 5, failed_at(101));
  EXPECT_EQ(attempts_without_progress(id), 0);
  AttemptEnd unknown;
  attempt_that_ends_with(unknown);  // no step known: no progress
  EXPECT_EQ(attempts_without_progress(id), 1);
  EXPECT_EQ(store.find_case(id)->attempts_without_progress, 1);
}

TEST_F(StoreTest, AllCasesAtOnceAreTheSameAsOneByOne) {
  attempt_that_ends_with(AttemptOutcome::kInterrupted, 100);
  attempt_that_ends_with(AttemptOutcome::kFailed, 90);
  attempt_that_ends_with(AttemptOutcome::kKilled, 100);
  const auto all = store.all_cases();
  ASSERT_EQ(all.size(), campaign.cases.size());
  EXPECT_EQ(all.at(id).attempts, 3);
  EXPECT_EQ(all.at(id).attempts_without_progress, 2);
  for (const CampaignCase& one : campaign.cases) {
    const CaseRecord alone = *store.find_case(one.definition.id);
    const CaseRecord& among = all.at(one.definition.id);
    EXPECT_EQ(std::tie(among.label, among.state, among.attempts, among.attempts_without_progress),
              std::tie(alone.label, alone.state, alone.attempts, alone.attempts_without_progress));
  }
  EXPECT_EQ(store.open_attempts(id).size(), 0U);
}

TEST_F(StoreTest, WritesInsideATransactionAreOneWithIt) {
  {
    Transaction together(store.connection());
    store.set_state(id, CaseState::kFailed, "lost again");
    store.forgive(id);
  }
  EXPECT_EQ(store.find_case(id)->state, CaseState::kNew);
  Transaction together(store.connection());
  store.set_state(id, CaseState::kFailed, "kept");
  together.commit();
  EXPECT_EQ(store.find_case(id)->state_reason, "kept");
}

TEST_F(StoreTest, WhatIsNotTheCasesFaultIsNotCounted) {
  attempt_that_ends_with(failed_at(0));
  for (const AttemptOutcome outcome : {AttemptOutcome::kInterrupted, AttemptOutcome::kLost,
                                       AttemptOutcome::kNotStarted, AttemptOutcome::kNodeFailure}) {
    attempt_that_ends_with(outcome, 0);
    EXPECT_EQ(attempts_without_progress(id), 1) << word_of(outcome);
  }
  attempt_that_ends_with(AttemptOutcome::kKilled, 0);
  attempt_that_ends_with(AttemptOutcome::kStalled, 0);
  EXPECT_EQ(attempts_without_progress(id), 3);
  store.forgive(id);
  EXPECT_EQ(attempts_without_progress(id), 0);
  attempt_that_ends_with(failed_at(0));
  EXPECT_EQ(attempts_without_progress(id), 1);
  EXPECT_EQ(attempts_without_progress(case_with(campaign, 4.0, 1.0).definition.id), 0);
}

TEST_F(StoreTest, EveryOutcomeHasAWordThatTheTableAccepts) {
  for (int value = 0; value <= static_cast<int>(AttemptOutcome::kFailed); ++value) {
    const auto outcome = static_cast<AttemptOutcome>(value);
    attempt_that_ends_with(outcome, 1);
    EXPECT_EQ(answer(store, "SELECT outcome FROM attempts ORDER BY attempt DESC LIMIT 1"), word_of(outcome));
    EXPECT_NE(word_of(outcome), "");
  }
}

TEST_F(StoreTest, ChecksTheLadderInAndOut) {
  CheckpointRecord older{"checkpoints/checkpoint-000000010.h5", 10, 0.1, 1000, "00", true, ""};
  CheckpointRecord newer{"checkpoints/checkpoint-000000020.h5", 20, 0.2, 1000, "11", true, ""};
  CheckpointRecord newest{"checkpoints/checkpoint-000000030.h5", 30, 0.3, 900, "22", false, "truncated"};
  store.record_checkpoints(id, {newer, older});
  store.record_checkpoints(id, {newest, newer});
  store.record_checkpoints(id, {newest, newer});
  EXPECT_EQ(answer(store, "SELECT count(*) FROM checkpoints"), "3");
  EXPECT_EQ(answer(store, "SELECT group_concat(step) FROM checkpoints WHERE present = 0"), "10");
  EXPECT_EQ(answer(store, "SELECT step || ' ' || reason FROM checkpoints WHERE valid = 0"), "30 truncated");
}

TEST_F(StoreTest, AResultReplacesTheFormerOneWhole) {
  analysis::DerivedQuantities derived = result_made_of(100.0);
  derived.delta_max = {std::nan(""), std::nullopt};
  derived.re_tau.ci95.reset();
  derived.note = "window too short";
  store.record_result(id, result_made_of(50.0), "old");
  store.record_result(id, derived, "new");
  EXPECT_EQ(answer(store, "SELECT re_tau_w FROM results WHERE case_id = '" + id + "'"), "100.0");
  EXPECT_EQ(answer(store, "SELECT re_tau_ci95 IS NULL FROM results WHERE case_id = '" + id + "'"), "1");
  EXPECT_EQ(answer(store, "SELECT delta_max IS NULL FROM results WHERE case_id = '" + id + "'"), "1");
  EXPECT_EQ(answer(store, "SELECT note FROM results WHERE case_id = '" + id + "'"), "window too short");
  EXPECT_EQ(answer(store, "SELECT count(*) FROM quantities WHERE git_revision = 'old'"), "0");
  const ResultOrigin origin = store.result_origin(id).value();
  EXPECT_EQ(origin.analysis_version, analysis::kAnalysisVersion);
  EXPECT_EQ(origin.window_start, 10.0);
  EXPECT_EQ(origin.window_end, 50.0);
}

TEST_F(StoreTest, LabelsAndReasonsAreStoredToTheLetter) {
  const std::vector<std::string> labels = {"a'); DROP TABLE cases;--",
                                           "\"; ATTACH 'x' AS y; --",
                                           "%s%n$(id)`id`",
                                           "\u202etxt.exe \U0001F30A",
                                           std::string("nul\0inside", 10),
                                           "",
                                           "?1 :a @b"};
  for (const std::string& label : labels) {
    CampaignCase changed = case_with(campaign, 1.0, 1.0);
    changed.definition.label = label;
    store.record_campaign(campaign_with(changed));
    store.set_state(id, CaseState::kFailed, label);
    EXPECT_EQ(store.find_case(id)->label, label);
    EXPECT_EQ(store.find_case(id)->state_reason, label);
  }
  EXPECT_EQ(answer(store, "SELECT count(*) FROM cases"), "7");
}

TEST_F(StoreTest, TellsTheStoryInOrder) {
  attempt_that_ends_with(failed_at(3));
  store.record_checkpoints(id, {{"checkpoints/checkpoint-000000003.h5", 3, 0.1, 10, "00", true, ""}});
  store.record_result(id, result_made_of(1.0), "abc");
  EXPECT_EQ(answer(store, "SELECT group_concat(event, '; ') FROM (SELECT * FROM timeline)"),
            "attempt intended; attempt ended; checkpoint seen; result recorded");
  EXPECT_EQ(answer(store, "SELECT outcome FROM attempt_history"), "failed");
  EXPECT_EQ(answer(store, "SELECT step FROM progress WHERE case_id = '" + id + "'"), "3");
}

/// Somebody has deleted a row with another program, which knows of no foreign keys.
TEST_F(StoreTest, ACaseThatIsMissingIsDamage) {
  EXPECT_EQ(store.begin_attempt(id, start), 1);
  store.connection().execute("PRAGMA foreign_keys = OFF");
  store.connection().execute("DELETE FROM quantities; DELETE FROM cases");
  for (const auto& look : std::vector<std::function<void()>>{[&] { (void)store.all_cases(); },
                                                             [&] { (void)store.find_case(id); }}) {
    try {
      look();
      ADD_FAILURE() << "nothing was noticed";
    } catch (const SqliteError& error) {
      EXPECT_TRUE(error.is_damage());
      EXPECT_NE(std::string(error.what()).find(id), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace softwall::campaign::tests
