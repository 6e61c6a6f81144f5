#include "solver/case/time_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwall {
namespace {

/// Number of steps of dt until the end is reached, times added up as the solver adds them.
int steps_to(double end, double dt) {
  int steps = 0;
  for (double time = 0; !has_reached(time, end); time += dt) ++steps;
  return steps;
}

TEST(TimeComparison, StepsAddUpToTheEnd) {
  EXPECT_EQ(steps_to(1, 0.1), 10);  // ten times 0.1 is a little less than 1
  EXPECT_EQ(steps_to(54.6, 0.05), 1092);
  EXPECT_EQ(steps_to(100, 1e-4), 1000000);
  EXPECT_EQ(steps_to(0.95, 0.1), 10);
}

TEST(TimeComparison, AnEndIsNotReachedAStepBefore) {
  EXPECT_FALSE(has_reached(1e4 - 1e-3, 1e4));
  EXPECT_FALSE(has_reached(0, 1e-320));
  EXPECT_TRUE(has_reached(1e-300, 1e-320));
}

TEST(TimeComparison, ARunHasEndedAtAGoalOnlyIfItStoppedThere) {
  EXPECT_TRUE(has_ended_at(300, 4000, 300));
  EXPECT_TRUE(has_ended_at(300.07, 4000, 300));
  EXPECT_FALSE(has_ended_at(299, 4000, 300));
  EXPECT_FALSE(has_ended_at(310, 4000, 300));
  EXPECT_FALSE(has_ended_at(656, 9000, 30));
  EXPECT_TRUE(has_ended_at(0, 0, 0));
}

TEST(TimeComparison, EveryIntervalPassesOnce) {
  for (const double dt : {0.1, 0.05, 0.01, 0.003}) {
    const double interval = 0.1;
    double time = 0;
    int passed = 0;
    while (!has_reached(time, 3.0)) {
      const double before = time;
      time += dt;
      const double intervals = intervals_passed(time, interval) - intervals_passed(before, interval);
      ASSERT_LE(intervals, 1) << dt << " at " << time;
      passed += static_cast<int>(intervals);
    }
    EXPECT_EQ(passed, 30) << dt;
  }
}

TEST(TimeComparison, PercentagesEndAtAHundred) {
  EXPECT_EQ(percent_done(0, 2), 0);
  EXPECT_EQ(percent_done(0.5, 2), 25);
  EXPECT_EQ(percent_done(1.999999, 2), 99);
  EXPECT_EQ(percent_done(5.08, 2), 100);  // the end was lowered
  EXPECT_EQ(percent_done(0.01, 1e-320), 100);
  EXPECT_EQ(percent_done(1, 1e308), 1e-306);
}

}  // namespace
}  // namespace softwall
