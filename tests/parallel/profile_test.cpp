#include "solver/parallel/profile.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace softwall::parallel {
namespace {

void sleep_ms(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

TEST(Profile, ChargesTimeToTheInnermostPhaseOnly) {
  Profile profile;
  const auto begin = std::chrono::steady_clock::now();
  {
    const Profile::Scope momentum(&profile, Phase::kMomentum);
    sleep_ms(5);
    {
      const Profile::Scope halo(&profile, Phase::kHalo);
      sleep_ms(20);
      profile.count_messages(2, 100);
    }
    sleep_ms(5);
  }
  const auto records = profile.read();
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto& momentum = records[static_cast<std::size_t>(Phase::kMomentum)];
  const auto& halo = records[static_cast<std::size_t>(Phase::kHalo)];
  EXPECT_GE(momentum.seconds, 0.010);
  EXPECT_GE(halo.seconds, 0.020);
  EXPECT_LE(momentum.seconds + halo.seconds, whole);
  EXPECT_EQ(halo.messages, 2);
  EXPECT_EQ(halo.bytes, 100);
  EXPECT_EQ(momentum.messages, 0);
}

TEST(Profile, ReturnsWhatTheWorkReturnsAndBeginsAgain) {
  Profile profile;
  EXPECT_EQ(profile.time(Phase::kPoisson,
                         [] {
                           sleep_ms(2);
                           return 7;
                         }),
            7);
  EXPECT_GT(profile.read()[static_cast<std::size_t>(Phase::kPoisson)].seconds, 0.001);
  profile.reset();
  EXPECT_EQ(profile.read()[static_cast<std::size_t>(Phase::kPoisson)].seconds, 0);
}

TEST(Profile, ScopeWithoutAProfileDoesNothing) {
  const Profile::Scope scope(nullptr, Phase::kHalo);
  SUCCEED();
}

}  // namespace
}  // namespace softwall::parallel
