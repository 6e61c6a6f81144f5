#include "solver/output/remembered_layout.hpp"

#include <gtest/gtest.h>

#include "solver/case/atomic_file.hpp"
#include "tests/output/shared_folder.hpp"
#include "tests/support/physics.hpp"

namespace softwall::output {
namespace {

using parallel::Layout;

constexpr int kMeasureAlways = 0;

class RememberedLayout : public ::testing::Test {
 protected:
  [[nodiscard]] std::optional<Layout> ask(int few = kMeasureAlways) const {
    return remembered_layout(run_, physics_, world_, few);
  }
  void write(const std::string& text) const {
    agree_on_root(world_, ExitCode::kFailed, [&] { write_atomically(run_.layout(), text); });
  }
  [[nodiscard]] Layout last_possible() const {
    return parallel::possible_layouts(world_.size(), physics_.grid.nx, physics_.grid.nz).back();
  }

  parallel::Communicator world_ = parallel::Communicator::duplicate(MPI_COMM_WORLD);
  support::SharedFolder folder_{world_};
  RunFiles run_{folder_.path()};
  Physics physics_ = support::rigid_channel({24, 8, 0, 24});
};

TEST_F(RememberedLayout, IsNotAskedForOnFewRanks) {
  EXPECT_EQ(ask(kFewRanks), std::nullopt);
  EXPECT_FALSE(std::filesystem::exists(run_.layout()));
}

TEST_F(RememberedLayout, IsMeasuredOnceAndKept) {
  if (world_.size() == 1) GTEST_SKIP() << "one rank has no choice";
  const auto first = ask();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->px * first->pz, world_.size());
  EXPECT_TRUE(std::filesystem::exists(run_.layout()));
  EXPECT_EQ(ask(), first);
}

TEST_F(RememberedLayout, IsTakenFromTheFileWhateverIsFaster) {
  if (world_.size() == 1) GTEST_SKIP() << "one rank has no choice";
  const Layout kept = last_possible();
  write(R"({"format":1,"layouts":{")" + std::to_string(world_.size()) + R"(":{"px":)" +
        std::to_string(kept.px) + R"(,"pz":)" + std::to_string(kept.pz) + "}}}");
  EXPECT_EQ(ask(), kept);
}

TEST_F(RememberedLayout, ReplacesWhatCannotBeUsed) {
  if (world_.size() == 1) GTEST_SKIP() << "one rank has no choice";
  const std::string ranks = std::to_string(world_.size());
  for (const std::string& text :
       {std::string("rubbish"), std::string("[]"), std::string(R"({"format":1,"layouts":7})"),
        R"({"format":1,"layouts":{")" + ranks + R"(":{"px":1000,"pz":1}}})",
        R"({"format":1,"layouts":{")" + ranks + R"(":{"px":"one"}}})"}) {
    write(text);
    const auto layout = ask();
    ASSERT_TRUE(layout) << text;
    EXPECT_EQ(layout->px * layout->pz, world_.size());
    EXPECT_EQ(ask(), layout);
  }
}

}  // namespace
}  // namespace softwall::output
