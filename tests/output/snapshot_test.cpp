#include "solver/output/snapshot.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "solver/output/agree.hpp"
#include "solver/output/checkpoint_reader.hpp"
#include "solver/run_directory/output_size.hpp"
#include "tests/output/sample_state.hpp"
#include "tests/output/shared_folder.hpp"

namespace softwall::output {
namespace {

/// Linear but for x and z, which are periodic.
double smooth(double x, double y, double z) {
  constexpr double kTwoPi = 6.283185307179586;
  return std::sin(kTwoPi * x / 3) * std::cos(kTwoPi * z / 1.5) + y;
}

class SnapshotTest : public testing::Test {
 protected:
  /// A snapshot of a state with the same formula everywhere.
  void write(time::State& state, time::Setup& setup, std::int64_t step) {
    state.step = step;
    state.time = 0.5 * static_cast<double>(step);
    write_snapshot(run_, state, setup, collection_);
  }
  [[nodiscard]] std::string collection_text() const {
    std::ostringstream text;
    text << std::ifstream(run_.fields() / "fields.xdmf").rdbuf();
    return text.str();
  }

  parallel::Communicator world_ = parallel::Communicator::duplicate(MPI_COMM_WORLD);
  support::SharedFolder folder_{world_};
  RunFiles run_{folder_.path()};
  Collection collection_ = collection_of_snapshots(run_);
};

TEST_F(SnapshotTest, HasTheDeformationAtTheCentres) {
  Physics physics = support::elastic_channel({12, 8, 4, 14});
  time::Setup setup(physics, world_.get());
  time::State state = time::state_at_rest(setup);
  support::set_by_position(state.material.B.xz, setup.grid, support::kEdgeXz, smooth);
  support::set_by_position(state.material.B.yz, setup.grid, support::kEdgeYz, smooth);
  support::set_by_position(state.material.B.xx, setup.grid, support::kCenter, smooth);
  write(state, setup, 3);
  const CheckpointFile file(run_.fields() / "fields-000000003.h5");
  const auto& g = setup.grid;
  const auto xz = file.columns("B_xz", {0, 12, 0, 14}), yz = file.columns("B_yz", {0, 12, 0, 14}),
             xx = file.columns("B_xx", {0, 12, 0, 14});
  std::size_t n = 0;
  for (int k = 0; k < 14; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i, ++n) {
        const auto mean_z = [&](double x, double y) {
          return (smooth(x, y, k * g.dz) + smooth(x, y, (k + 1) * g.dz)) / 2;
        };
        const double x = i * g.dx, y = g.y_center[j];
        EXPECT_NEAR(xz[n], (mean_z(x, y) + mean_z(x + g.dx, y)) / 2, 1e-13);
        EXPECT_NEAR(yz[n], (mean_z(x + g.dx / 2, g.y_face[j]) + mean_z(x + g.dx / 2, g.y_face[j + 1])) / 2,
                    1e-13);
        EXPECT_EQ(xx[n], smooth(x + g.dx / 2, y, (k + 0.5) * g.dz));
      }
}

/// [nz][ny][nx][components] without storing a number twice.
TEST_F(SnapshotTest, JoinsComponentsToVectorsAndTensors) {
  Physics physics = support::elastic_channel({12, 8, 4, 14});
  physics.solid->formulation = SolidFormulation::kReferenceMap;
  time::Setup setup(physics, world_.get());
  time::State state = time::state_at_rest(setup);
  support::set_by_position(state.velocity.y, setup.grid, support::kFaceY, smooth);
  support::set_by_position(state.material.displacement.z, setup.grid, support::kFaceZ, smooth);
  write(state, setup, 0);
  const auto path = run_.fields() / "fields-000000000.h5";
  const CheckpointFile file(path);
  const analysis::Hdf5Id opened(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "cannot open");
  for (const auto& [joined, component, number] :
       {std::tuple("velocity", "v", 1U), std::tuple("displacement", "d_z", 2U)}) {
    const auto alone = file.columns(component, {0, 12, 0, 14});
    std::vector<double> all(3 * alone.size());
    const auto dataset = analysis::open_dataset(opened.get(), joined);
    ASSERT_GE(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0);
    EXPECT_GT(std::abs(alone[40]), 0);
    for (std::size_t n = 0; n < alone.size(); ++n) EXPECT_EQ(all[3 * n + number], alone[n]);
  }
  EXPECT_LT(std::filesystem::file_size(path), (4U + 1U + 3U) * 12 * 12 * 14 * sizeof(grid::Real) + 40'000U);
}

TEST_F(SnapshotTest, StandInOneCollectionWithTheirTimes) {
  time::Setup setup(support::rigid_channel({12, 8, 0, 14}), world_.get());
  time::State state = time::state_at_rest(setup);
  for (const std::int64_t step : {20, 0, 7}) write(state, setup, step);
  if (world_.rank() == 0) std::ofstream(run_.fields() / "fields-000000009.h5") << "no snapshot";
  write(state, setup, 30);
  const std::string text = collection_text();
  std::size_t at = 0;
  for (const char* part : {"CollectionType=\"Temporal\"", "<Time Value=\"0\"/>", "fields-000000000.h5:/x",
                           "Dimensions=\"14 8 12 3\">fields-000000000.h5:/velocity", "<Time Value=\"3.5\"/>",
                           "fields-000000007.h5:/p", "<Time Value=\"10\"/>", "<Time Value=\"15\"/>"}) {
    const std::size_t found = text.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << "\n" << text;
    at = found;
  }
  EXPECT_EQ(text.find("fields-000000009"), std::string::npos);
  EXPECT_EQ(text.find("phi"), std::string::npos);
}

TEST_F(SnapshotTest, ThoseOfALostTrajectoryAreRemoved) {
  time::Setup setup(support::rigid_channel({12, 8, 0, 14}), world_.get());
  time::State state = time::state_at_rest(setup);
  for (const std::int64_t step : {0, 10, 21, 30}) write(state, setup, step);
  const auto of_user = run_.fields() / "fields-mean.h5";
  agree_on_root(world_, ExitCode::kIoFailure, [&] {
    std::ofstream(of_user) << "what a user made of them";
    collection_.remove_later_than(run_.fields_of(20));
  });
  EXPECT_TRUE(std::filesystem::exists(of_user));
  for (const std::int64_t step : {0, 10}) EXPECT_TRUE(std::filesystem::exists(run_.fields_of(step))) << step;
  for (const std::int64_t step : {21, 30}) {
    const std::string name = run_.fields_of(step).filename();
    EXPECT_FALSE(std::filesystem::exists(run_.fields() / name)) << name;
    EXPECT_EQ(collection_text().find(name), std::string::npos) << name;
  }
  write(state, setup, 22);
  EXPECT_NE(collection_text().find("fields-000000022"), std::string::npos);
  EXPECT_NE(collection_text().find("fields-000000010"), std::string::npos);
}

/// But for what HDF5 keeps for itself, which is less than a field.
TEST_F(SnapshotTest, ItsSizeIsKnownFromTheCaseAlone) {
  std::vector<Physics> all = {support::rigid_channel({24, 16, 0, 24})};
  for (const auto formulation : support::kBothFormulations)
    all.push_back(support::formulated(support::elastic_channel({24, 12, 4, 24}), formulation));
  std::int64_t step = 0;
  for (Physics& physics : all) {
    physics.precision = grid::kPrecision;
    time::Setup setup(physics, world_.get());
    time::State state = time::state_at_rest(setup);
    write(state, setup, ++step);
    const auto file = run_.fields() / ("fields-00000000" + std::to_string(step) + ".h5");
    const auto more =
        static_cast<std::int64_t>(std::filesystem::file_size(file)) - snapshot_field_bytes(physics);
    EXPECT_GT(more, 0);
    EXPECT_LT(more, std::int64_t{24} * 16 * 24 * sizeof(grid::Real));
  }
}

}  // namespace
}  // namespace softwall::output
