#include <gtest/gtest.h>

#include "solver/parallel/decomposition.hpp"

namespace softwall::parallel {
namespace {

TEST(Share, CoversEverythingOnceInOrder) {
  for (int n = 0; n <= 40; ++n) {
    for (int parts = 1; parts <= 9; ++parts) {
      int next = 0;
      for (int index = 0; index < parts; ++index) {
        const Range part = share(n, parts, index);
        ASSERT_EQ(part.begin, next) << n << " in " << parts;
        ASSERT_GE(part.size(), 0);
        next = part.end;
      }
      EXPECT_EQ(next, n);
    }
  }
}

TEST(Share, IsEvenAndLargerPartsComeFirst) {
  for (int n = 0; n <= 40; ++n) {
    for (int parts = 1; parts <= 9; ++parts) {
      for (int index = 0; index < parts; ++index) {
        const int larger = index < n % parts ? 1 : 0;
        EXPECT_EQ(share(n, parts, index).size(), n / parts + larger) << n << " in " << parts;
      }
    }
  }
}

TEST(Share, SharesListsEveryPart) {
  const auto all = shares(11, 4);
  ASSERT_EQ(all.size(), 4U);
  for (int index = 0; index < 4; ++index) {
    EXPECT_EQ(all[static_cast<std::size_t>(index)].begin, share(11, 4, index).begin);
    EXPECT_EQ(all[static_cast<std::size_t>(index)].end, share(11, 4, index).end);
  }
}

}  // namespace
}  // namespace softwall::parallel
