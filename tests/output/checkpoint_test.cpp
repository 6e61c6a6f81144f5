#include <gtest/gtest.h>

#include <fstream>

#include "solver/output/checkpoint_reader.hpp"
#include "solver/output/checkpoints.hpp"
#include "solver/run_directory/output_size.hpp"
#include "solver/time/initial.hpp"
#include "tests/output/sample_state.hpp"
#include "tests/output/shared_folder.hpp"

namespace softwall::output {
namespace {

using support::kCaseId;

class CheckpointTest : public testing::Test {
 protected:
  parallel::Communicator world_ = parallel::Communicator::duplicate(MPI_COMM_WORLD);
  support::SharedFolder folder_{world_};
  RunFiles run_{folder_.path()};

  /// Writes the numbered state of these steps, with the same setup.
  void write(const Physics& physics, std::initializer_list<std::int64_t> steps) {
    time::Setup setup(physics, world_.get());
    for (const std::int64_t step : steps) {
      time::State state = support::numbered_state(setup, step);
      static_cast<void>(write_checkpoint(run_, {kCaseId, 3}, state, support::sample_record(), setup));
    }
  }

  /// Changes one byte of a file.
  void flip(const std::filesystem::path& file, std::int64_t offset) const {
    if (world_.rank() == 0) {
      std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
      stream.seekg(offset);
      const char byte = static_cast<char>(stream.get() ^ 0x10);
      stream.seekp(offset);
      stream.put(byte);
    }
    MPI_Barrier(world_.get());
  }

  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(run_.checkpoints())) {
      names.insert(entry.path().filename().string());
    }
    MPI_Barrier(world_.get());
    return names;
  }
};

/// Written by all ranks, read by any number of them: every number comes back exactly.
void expect_round_trip(const Physics& physics, const parallel::Communicator& readers,
                       const FoundCheckpoint& found) {
  time::Setup setup(physics, readers.get());
  time::State state = time::state_at_rest(setup);
  const CheckpointContents record = load_checkpoint(found.file, found.header, setup, state);
  time::State expected = support::numbered_state(setup, 12);
  EXPECT_EQ(support::all_fields(state, setup), support::all_fields(expected, setup));
  EXPECT_EQ(state.step, expected.step);
  EXPECT_EQ(state.time, expected.time);
  EXPECT_EQ(state.driving_gradient, expected.driving_gradient);
  EXPECT_EQ(record.statistics, support::sample_record().statistics);
  EXPECT_EQ(record.limited_cells, 17);
  EXPECT_EQ(record.limited_since_step, 3);
  EXPECT_EQ(record.solid_volume_at_start, 2.25);
}

TEST_F(CheckpointTest, ComesBackExactlyOnAnyNumberOfRanks) {
  const std::vector<Physics> cases{
      support::rigid_channel({16, 6, 0, 12}), support::rigid_channel({13, 5, 0, 14}),
      support::elastic_channel({15, 8, 4, 13}), support::elastic_channel({6, 7, 5, 6})};
  for (const Physics& physics : cases) {
    write(physics, {12});
    Checkpoints checkpoints(run_, kCaseId, 2);
    const auto found = checkpoints.newest_valid(world_);
    ASSERT_TRUE(found.has_value());
    expect_round_trip(physics, world_, *found);
    for (const int readers : {1, 2}) {  // ranks in groups, each reading the whole state
      const auto group = parallel::Communicator::split(world_.get(), world_.rank() / readers, world_.rank());
      expect_round_trip(physics, group, *found);
    }
  }
}

TEST_F(CheckpointTest, ItsSizeIsKnownFromTheCaseAlone) {
  const support::Cells cells{8, 12, 4, 6};
  std::vector<Physics> all = {support::rigid_channel({8, 12, 0, 6})};
  for (const auto formulation : support::kBothFormulations)
    all.push_back(support::formulated(support::elastic_channel(cells), formulation));
  for (Physics& physics : all) {
    physics.precision = grid::kPrecision;
    time::Setup setup(physics, world_.get());
    time::State state = time::state_at_rest(setup);
    EXPECT_EQ(checkpoint_field_bytes(physics), checkpoint_bytes(state, setup.grid));
  }
}

TEST_F(CheckpointTest, HeaderSaysWhatTheFileHolds) {
  write(support::elastic_channel({15, 8, 4, 13}), {12});
  const auto header = read_checkpoint_header(run_.checkpoint(12));
  EXPECT_EQ(header.case_id, kCaseId);
  EXPECT_EQ(header.step, 12);
  EXPECT_EQ(header.attempt, 3);
  EXPECT_EQ(header.ranks, world_.size());
  EXPECT_EQ(header.grid, (std::array<int, 3>{15, 12, 13}));
  EXPECT_EQ(header.length, (std::array<double, 3>{3, 3, 1.5}));
  EXPECT_EQ(header.bytes, static_cast<std::int64_t>(std::filesystem::file_size(run_.checkpoint(12))));
}

TEST_F(CheckpointTest, SameStateGivesTheSameBytes) {
  const Physics physics = support::elastic_channel({12, 6, 4, 12});
  write(physics, {12});
  const auto first = read_checkpoint_header(run_.checkpoint(12)).xxh3;
  MPI_Barrier(world_.get());
  write(physics, {12});
  EXPECT_EQ(read_checkpoint_header(run_.checkpoint(12)).xxh3, first);
}

TEST_F(CheckpointTest, DamagedOnesAreNamedAndTheOneBeforeIsUsed) {
  write(support::rigid_channel({12, 6, 0, 12}), {10, 20, 30, 40});
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(run_.checkpoint(40)));
  flip(run_.checkpoint(40), size / 2);
  if (world_.rank() == 0)
    std::filesystem::resize_file(run_.checkpoint(30), static_cast<std::uintmax_t>(size - 1));
  flip(run_.checkpoint(20), 40);  // in the header
  Checkpoints checkpoints(run_, kCaseId, 2);
  const auto found = checkpoints.newest_valid(world_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->file, run_.checkpoint(10));
  if (world_.rank() == 0) {
    ASSERT_EQ(checkpoints.refused().size(), 3U);
    EXPECT_NE(checkpoints.refused()[0].find("checkpoint-000000040.h5"), std::string::npos);
    EXPECT_NE(checkpoints.refused()[0].find("digest"), std::string::npos);
    EXPECT_NE(checkpoints.refused()[1].find("bytes"), std::string::npos);
    EXPECT_NE(checkpoints.refused()[2].find("checkpoint-000000020.h5"), std::string::npos);
  }
  EXPECT_EQ(files().size(), 4U);
}

TEST_F(CheckpointTest, NoneUsableIsRefusedWithEveryReason) {
  write(support::rigid_channel({12, 6, 0, 12}), {10, 20});
  flip(run_.checkpoint(10), 5000);
  flip(run_.checkpoint(20), 5000);
  Checkpoints checkpoints(run_, kCaseId, 2);
  try {
    static_cast<void>(checkpoints.newest_valid(world_));
    ADD_FAILURE() << "accepted a damaged checkpoint";
  } catch (const AgreedError& error) {
    EXPECT_EQ(error.code, ExitCode::kCheckpointRefused);
    EXPECT_NE(std::string(error.what()).find("checkpoint-000000010.h5"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("checkpoint-000000020.h5"), std::string::npos);
  }
}

TEST_F(CheckpointTest, AnotherCaseIsRefusedWithBothNames) {
  write(support::rigid_channel({12, 6, 0, 12}), {10});
  Checkpoints checkpoints(run_, "ffffffffffffffff", 2);
  try {
    static_cast<void>(checkpoints.newest_valid(world_));
    ADD_FAILURE() << "accepted another case's checkpoint";
  } catch (const AgreedError& error) {
    EXPECT_NE(std::string(error.what()).find(kCaseId), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("ffffffffffffffff"), std::string::npos);
  }
}

TEST_F(CheckpointTest, AFileUnderTheNameOfAnotherStepIsPassedOver) {
  write(support::rigid_channel({12, 6, 0, 12}), {10, 20});
  if (world_.rank() == 0) std::filesystem::rename(run_.checkpoint(20), run_.checkpoint(99));
  Checkpoints checkpoints(run_, kCaseId, 2);
  EXPECT_EQ(checkpoints.newest_valid(world_)->file, run_.checkpoint(10));
}

TEST_F(CheckpointTest, AnotherGridIsRefusedWithBothValues) {
  write(support::rigid_channel({12, 6, 0, 12}), {10});
  Checkpoints checkpoints(run_, kCaseId, 2);
  const auto found = checkpoints.newest_valid(world_);
  time::Setup setup(support::rigid_channel({12, 8, 0, 12}), world_.get());
  time::State state = time::state_at_rest(setup.grid, std::nullopt);
  try {
    static_cast<void>(load_checkpoint(found->file, found->header, setup, state));
    ADD_FAILURE() << "accepted another grid";
  } catch (const AgreedError& error) {
    EXPECT_EQ(error.code, ExitCode::kCheckpointRefused);
    EXPECT_NE(std::string(error.what()).find("12 x 6 x 12"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("12 x 8 x 12"), std::string::npos) << error.what();
  }
}

TEST_F(CheckpointTest, OneNumberThatIsNotFiniteOnOneRankIsNeverWritten) {
  time::Setup setup(support::elastic_channel({12, 6, 4, 12}), world_.get());
  time::State state = support::numbered_state(setup, 5);
  if (world_.rank() == world_.size() - 1) state.material.B.xz(0, 2, 1) = std::nan("");
  EXPECT_THROW(static_cast<void>(write_checkpoint(run_, {kCaseId, 0}, state, {}, setup)), AgreedError);
  EXPECT_FALSE(std::filesystem::exists(run_.checkpoint(5)));
}

TEST_F(CheckpointTest, OldGenerationsGoAndRefusedOnesStay) {
  write(support::rigid_channel({12, 6, 0, 12}), {10, 20, 30, 40});
  flip(run_.checkpoint(40), 5000);
  Checkpoints checkpoints(run_, kCaseId, 2);
  EXPECT_EQ(checkpoints.newest_valid(world_)->file, run_.checkpoint(30));
  write(support::rigid_channel({12, 6, 0, 12}), {35});
  checkpoints.prune(run_.checkpoint(35), world_);
  EXPECT_EQ(files(), (std::set<std::string>{"checkpoint-000000030.h5", "checkpoint-000000035.h5",
                                            "checkpoint-000000040.h5"}));
}

TEST_F(CheckpointTest, NothingIsDeletedUnlessTheNewestReadsBack) {
  write(support::rigid_channel({12, 6, 0, 12}), {10, 20, 30});
  Checkpoints checkpoints(run_, kCaseId, 2);
  flip(run_.checkpoint(30), 100);
  EXPECT_THROW(checkpoints.prune(run_.checkpoint(30), world_), AgreedError);
  EXPECT_EQ(files().size(), 3U);
}

TEST_F(CheckpointTest, LeftoversOfAKilledWriterAreSwept) {
  write(support::rigid_channel({12, 6, 0, 12}), {10});
  if (world_.rank() == 0) {
    std::ofstream(run_.checkpoints() / "checkpoint-000000011.h5.tmp") << "half";
    std::ofstream(run_.checkpoints() / "checkpoint-000000011.h5.tmp-1701904385-2457.lock") << "Open MPI's";
    std::ofstream(run_.checkpoints() / "checkpoint-000000012.h5.tmp.locktest.0") << "Open MPI's, too";
    std::ofstream(run_.checkpoints() / "notes.tmp") << "a person's";
  }
  MPI_Barrier(world_.get());
  const Checkpoints checkpoints(run_, kCaseId, 2);
  checkpoints.sweep(world_);
  EXPECT_EQ(files(), (std::set<std::string>{"checkpoint-000000010.h5", "notes.tmp"}));
}

}  // namespace
}  // namespace softwall::output
