#include "campaign/core/plan.hpp"

#include <gtest/gtest.h>

#include "tests/campaign/core/examples.hpp"

/// Observations made by hand: the decisions need no solver, no disk and no clock.
namespace softwall::campaign {
namespace {

CampaignCase rigid(const std::string& id) {
  CampaignCase c;
  c.definition.id = id;
  c.definition.label = id;
  c.definition.run.end_time = 10.0;
  c.is_precursor = true;
  return c;
}

CampaignCase elastic(const std::string& id) {
  CampaignCase c = rigid(id);
  c.is_precursor = false;
  c.precursor_id = "P";
  return c;
}

Campaign campaign() {
  Campaign made;
  made.cases = {rigid("P"), elastic("A"), elastic("B"), elastic("C")};
  return made;
}

Observation seen(const std::string& id, CaseState state, double time = 5.0) {
  Observation observation;
  observation.case_id = id;
  observation.state = state;
  observation.time = time;
  observation.step = static_cast<std::int64_t>(100 * time);
  observation.attempts = state == CaseState::kNew ? 0 : 1;
  observation.running = state == CaseState::kRunning;
  if (time > 0.0 && state != CaseState::kNew)
    observation.newest_checkpoint = "cases/" + id + "/checkpoint.h5";
  return observation;
}

Observation finished(const std::string& id) { return seen(id, CaseState::kFinished, 10.0); }

Decision decision(const Campaign& c, const std::vector<Observation>& observations, const std::string& id) {
  for (const auto& made : decide(c, observations))
    if (made.case_id == id) return made;
  ADD_FAILURE() << "no decision for " << id;
  return {};
}

/// "start P, resume A"
std::string planned(const Campaign& c, const std::vector<Observation>& observations, int cores = 100) {
  std::string text;
  for (const auto& action : plan(c, observations, cores))
    text += (text.empty() ? "" : ", ") + to_string(decision(c, observations, action.case_id).outlook) + " " +
            action.case_id;
  return text;
}

TEST(Plan, ThePrecursorComesFirstAndAlone) {
  EXPECT_EQ(planned(campaign(), {}), "start P");
  EXPECT_EQ(decision(campaign(), {}, "A").outlook, Outlook::kWaiting);
  EXPECT_EQ(decision(campaign(), {}, "A").reason, "for P");
  EXPECT_EQ(planned(campaign(), {seen("P", CaseState::kRunning)}), "");
}

TEST(Plan, ThenAllThatFit) {
  EXPECT_EQ(planned(campaign(), {finished("P")}), "start A, start B, start C");
  EXPECT_EQ(planned(campaign(), {finished("P")}, 2), "start A, start B");
  EXPECT_EQ(planned(campaign(), {finished("P")}, 0), "");
  EXPECT_EQ(planned(campaign(), {finished("P")}, -1), "");
  Campaign wide = campaign();
  wide.cases[1].ranks = 4;
  EXPECT_EQ(planned(wide, {finished("P")}, 3), "start B, start C");
  EXPECT_EQ(plan(wide, {finished("P")}, 4).front().ranks, 4);
}

TEST(Plan, StartsFromThePrecursorsCheckpoint) {
  const auto actions = plan(campaign(), {finished("P"), seen("A", CaseState::kInterrupted)}, 100);
  for (const auto& action : actions) EXPECT_EQ(action.initial_checkpoint, "cases/P/checkpoint.h5");
  EXPECT_TRUE(plan(campaign(), {}, 100).front().initial_checkpoint.empty());
}

TEST(Plan, ResumesWhatWasInterruptedOrFailed) {
  EXPECT_EQ(planned(campaign(), {finished("P"), seen("A", CaseState::kInterrupted),
                                 seen("B", CaseState::kFailed), finished("C")}),
            "resume A, resume B");
  Observation early = seen("A", CaseState::kFailed, 0.0);
  EXPECT_EQ(planned(campaign(), {finished("P"), early, finished("B"), finished("C")}), "start A");
  EXPECT_EQ(planned(campaign(), {seen("P", CaseState::kInterrupted)}), "resume P");
}

/// It has its own checkpoint, so what became of the precursor's files does not matter.
TEST(Plan, AStartedCaseNoLongerNeedsItsPrecursor) {
  EXPECT_EQ(planned(campaign(), {seen("P", CaseState::kDiverged), seen("A", CaseState::kInterrupted)}),
            "resume A");
}

TEST(Plan, NeverRunsACaseTwiceAtOnce) {
  Observation odd = seen("A", CaseState::kInterrupted);
  odd.running = true;
  EXPECT_EQ(planned(campaign(), {finished("P"), odd, finished("B"), seen("C", CaseState::kRunning)}), "");
  EXPECT_EQ(decision(campaign(), {finished("P"), odd}, "A").outlook, Outlook::kRunning);
}

TEST(Plan, TellsAJobThatWaitsFromOneAtWork) {
  Observation job = seen("A", CaseState::kRunning);
  job.presence = Presence::kRunning;
  EXPECT_EQ(decision(campaign(), {finished("P"), job}, "A").reason, "a solver is at work on it");
  job.presence = Presence::kQueued;
  EXPECT_EQ(decision(campaign(), {finished("P"), job}, "A").reason, "its job waits in the queue");
  job.presence = Presence::kUnknown;
  EXPECT_EQ(decision(campaign(), {finished("P"), job}, "A").outlook, Outlook::kRunning);
  EXPECT_NE(decision(campaign(), {finished("P"), job}, "A").reason.find("nobody can say"), std::string::npos);
}

TEST(Plan, NothingIsLeftWhenAllIsDone) {
  EXPECT_EQ(planned(campaign(), {finished("P"), finished("A"), finished("B"), finished("C")}), "");
  EXPECT_EQ(decision(campaign(), {finished("A")}, "A").outlook, Outlook::kKept);
}

TEST(Plan, AnExtendedCaseGoesOn) {
  Campaign longer = campaign();
  longer.cases[1].definition.run.end_time = 20.0;
  EXPECT_EQ(planned(longer, {finished("P"), finished("A"), finished("B"), finished("C")}), "resume A");
}

TEST(Plan, DivergedIsNeverRunAgain) {
  Observation diverged = seen("A", CaseState::kDiverged);
  diverged.reason = "B not finite at step 12";
  const std::vector<Observation> observations{finished("P"), diverged};
  EXPECT_EQ(planned(campaign(), observations), "start B, start C");
  const Decision made = decision(campaign(), observations, "A");
  EXPECT_EQ(made.outlook, Outlook::kBlocked);
  EXPECT_NE(made.reason.find("B not finite at step 12"), std::string::npos);
}

TEST(Plan, NothingStartsFromALostPrecursor) {
  const std::vector<Observation> observations{seen("P", CaseState::kDiverged)};
  EXPECT_EQ(planned(campaign(), observations), "");
  EXPECT_EQ(decision(campaign(), observations, "B").outlook, Outlook::kBlocked);
  EXPECT_NE(decision(campaign(), observations, "B").reason.find("needs P: diverged"), std::string::npos);
  Observation empty = finished("P");
  empty.newest_checkpoint.reset();
  EXPECT_EQ(planned(campaign(), {empty}), "");
  EXPECT_NE(decision(campaign(), {empty}, "A").reason.find("none of its checkpoints is valid"),
            std::string::npos);
}

TEST(Plan, NothingStartsFromATimeThatItDoesNotName) {
  const Observation far = seen("P", CaseState::kFinished, 656.3),
                    near = seen("P", CaseState::kFinished, 10.05);
  EXPECT_EQ(planned(campaign(), {far}), "");
  EXPECT_NE(decision(campaign(), {far}, "A").reason.find("P is at t = 656.3, beyond the end time of 10 "),
            std::string::npos)
      << decision(campaign(), {far}, "A").reason;
  EXPECT_EQ(planned(campaign(), {near}), "start A, start B, start C");
  // One that has begun has its start behind it.
  EXPECT_EQ(planned(campaign(), {far, seen("A", CaseState::kInterrupted)}), "resume A");
}

TEST(Plan, RetriesEndWithoutProgress) {
  Observation failing = seen("A", CaseState::kFailed);
  failing.attempts = 50;
  failing.attempts_without_progress = 1;
  EXPECT_EQ(planned(campaign(), {finished("P"), failing, finished("B"), finished("C")}), "resume A");
  failing.attempts_without_progress = 2;
  EXPECT_EQ(planned(campaign(), {finished("P"), failing, finished("B"), finished("C")}), "");
  Campaign patient = campaign();
  patient.execution.max_failures_without_progress = 3;
  EXPECT_EQ(planned(patient, {finished("P"), failing, finished("B"), finished("C")}), "resume A");
}

TEST(Plan, WhatCannotSucceedIsNotTried) {
  Observation refused = seen("A", CaseState::kFailed, 0.0);
  refused.retry_allowed = false;
  EXPECT_EQ(planned(campaign(), {finished("P"), refused, finished("B"), finished("C")}), "");
  Campaign small = campaign();
  small.execution.cores = 2;
  small.cases[2].ranks = 3;
  EXPECT_EQ(planned(small, {finished("P")}), "start A, start C");
  EXPECT_NE(decision(small, {finished("P")}, "B").reason.find("needs 3 cores, there are 2"),
            std::string::npos);
}

TEST(Plan, WhatAPersonMustSeeToIsLeftAlone) {
  Observation unreadable = seen("A", CaseState::kInterrupted);
  unreadable.needs_person = "cannot be read";
  const Campaign c = campaign();
  const Decision made = decision(c, {finished("P"), unreadable}, "A");
  EXPECT_EQ(made.outlook, Outlook::kBlocked);
  EXPECT_EQ(made.reason, "cannot be read");
}

TEST(Plan, ObservationsOfOthersAreIgnored) {
  EXPECT_EQ(planned(campaign(), {finished("P"), seen("Z", CaseState::kInterrupted)}, 1), "start A");
}

TEST(Plan, EveryDecisionHasAReason) {
  for (const CaseState state : {CaseState::kNew, CaseState::kRunning, CaseState::kFinished,
                                CaseState::kInterrupted, CaseState::kDiverged, CaseState::kFailed})
    for (const double time : {0.0, 5.0, 10.0})
      for (const auto& made : decide(campaign(), {seen("P", state, time), seen("A", state, time)}))
        EXPECT_FALSE(made.reason.empty()) << made.case_id << to_string(made.outlook);
}

/// Carrying out plans until nothing is left ends with every case finished, whatever the cores.
TEST(Plan, CarriedOutItFinishesTheCampaign) {
  for (const int cores : {1, 2, 3, 8}) {
    std::vector<Observation> observations;
    const Campaign c = campaign();
    int rounds = 0;
    for (auto actions = plan(c, observations, cores); !actions.empty();
         actions = plan(c, observations, cores)) {
      for (const auto& action : actions) observations.push_back(finished(action.case_id));
      ASSERT_LE(++rounds, 4);
    }
    EXPECT_EQ(observations.size(), 4U) << cores;
  }
}

/// P starts A, A starts B, B starts C: a line of cases.
Campaign line() {
  Campaign made = campaign();
  made.cases[2].precursor_id = "A";
  made.cases[3].precursor_id = "B";
  return made;
}

TEST(Plan, ALineRunsOneCaseAfterTheOther) {
  EXPECT_EQ(planned(line(), {}), "start P");
  EXPECT_EQ(planned(line(), {finished("P")}), "start A");
  EXPECT_EQ(planned(line(), {finished("P"), finished("A")}), "start B");
  EXPECT_EQ(decision(line(), {finished("P"), finished("A")}, "B").reason, "new, from the end of A");
  EXPECT_EQ(decision(line(), {finished("P")}, "C").reason, "for B");
  EXPECT_EQ(plan(line(), {finished("P"), finished("A")}, 1).front().initial_checkpoint,
            "cases/A/checkpoint.h5");
}

TEST(Plan, AllThatWaitInALineNameTheOneThatCannotGoOn) {
  Observation diverged = seen("A", CaseState::kDiverged);
  diverged.reason = "too fast";
  const std::vector<Observation> now{finished("P"), diverged};
  for (const char* id : {"B", "C"}) {
    EXPECT_EQ(decision(line(), now, id).outlook, Outlook::kBlocked);
    EXPECT_EQ(decision(line(), now, id).reason,
              "needs A: diverged, after: too fast; it would do so again unchanged (another version of the "
              "solver may not: remove its checkpoints, then resume --start-over)");
  }
  Campaign narrow = line();
  narrow.execution.cores = 1;
  narrow.cases[2].ranks = 2;
  EXPECT_EQ(decision(narrow, {finished("P"), finished("A")}, "C").reason,
            "needs B: needs 2 cores, there are 1");
}

}  // namespace
}  // namespace softwall::campaign
