#include "solver/output/film.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "solver/output/snapshot.hpp"
#include "solver/run_directory/output_size.hpp"
#include "solver/statistics/interface_height.hpp"
#include "solver/time/advance.hpp"
#include "tests/output/sample_state.hpp"
#include "tests/output/shared_folder.hpp"

namespace softwall::output {
namespace {

/// Numbers of a dataset and how many there are along each dimension.
struct Read {
  std::vector<double> values;
  std::vector<hsize_t> shape;
  std::size_t bytes = 0;  ///< of one number in the file
};

Read read(const std::filesystem::path& path, const std::string& name) {
  const analysis::QuietHdf5 quiet;
  const analysis::Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "cannot open");
  const auto dataset = analysis::open_dataset(file.get(), name);
  const analysis::Hdf5Id space(H5Dget_space(dataset.get()), H5Sclose, "no shape");
  const analysis::Hdf5Id type(H5Dget_type(dataset.get()), H5Tclose, "no type");
  Read all;
  all.bytes = H5Tget_size(type.get());
  all.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.get())));
  H5Sget_simple_extent_dims(space.get(), all.shape.data(), nullptr);
  all.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
  EXPECT_GE(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.values.data()), 0);
  return all;
}

std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write_moment(Film& film, const time::State& state, const time::Setup& setup) {
  film.write(state, film.has_layer() ? statistics::heights_of_interface(state.material, setup.grid)
                                     : std::vector<double>());
}

constexpr int kNx = 12, kNy = 12, kNz = 14;

class FilmTest : public testing::Test {
 protected:
  /// A soft wall with a plane across each axis.
  [[nodiscard]] static Case soft_wall() {
    Case one;
    one.id = support::kCaseId;
    one.physics = support::elastic_channel({kNx, 8, 4, kNz});
    one.run.planes = {.x = {0.3}, .y = {0, 2.9}, .z = {1.5}};
    return one;
  }

  parallel::Communicator world_ = parallel::Communicator::duplicate(MPI_COMM_WORLD);
  support::SharedFolder folder_{world_};
  RunFiles run_{folder_.path()};
};

/// The rest of the grid's numbers: rounded means of the two ends of each cell.
TEST_F(FilmTest, HoldTheNumbersOfTheState) {
  const Case definition = soft_wall();
  time::Setup setup(definition.physics, world_.get());
  time::State state = support::numbered_state(setup, 12);
  time::start(state, setup);
  const auto all = [&](const grid::Field& field, int rows) {
    return support::global_values(field, setup.grid, rows, world_);
  };
  const auto u = all(state.velocity.x, kNy), v = all(state.velocity.y, kNy + 1),
             w = all(state.velocity.z, kNy), p = all(state.pressure, kNy), phi = all(state.material.phi, kNy);
  const auto at = [](const std::vector<double>& values, int rows, int i, int j, int k) {
    return static_cast<grid::Real>(values[static_cast<std::size_t>(((k % kNz) * rows + j) * kNx + i % kNx)]);
  };
  Film film(run_, definition, setup);
  write_moment(film, state, setup);
  const auto file = run_.planes() / "planes-000000012.h5";
  EXPECT_EQ(read(file, "moment/time").values.at(0), state.time);
  EXPECT_EQ(read(file, "moment/step").values.at(0), 12);
  const auto& g = setup.grid;
  // x = 0.3 lies in the second cell, y = 0 and 2.9 in the first and last row, z = 1.5 is the end of the box.
  EXPECT_DOUBLE_EQ(read(file, "x_0/position").values.at(0), 1.5 * g.dx);
  EXPECT_EQ(read(file, "y_1/position").values.at(0), g.y_center[kNy - 1]);
  const auto expect_plane = [&](const std::string& name, std::vector<hsize_t> shape, const auto& cell_of) {
    const Read got_u = read(file, name + "/u"), got_v = read(file, name + "/v"),
               got_w = read(file, name + "/w"), got_p = read(file, name + "/p"),
               got_phi = read(file, name + "/phi");
    ASSERT_EQ(got_u.shape, shape) << name;
    EXPECT_EQ(got_u.bytes, 4U);
    ASSERT_EQ(got_phi.values.size(), got_u.values.size());
    for (std::size_t n = 0; n < got_u.values.size(); ++n) {
      const auto [i, j, k] = cell_of(static_cast<int>(n / shape[1]), static_cast<int>(n % shape[1]));
      const auto rounded = [](grid::Real value) { return static_cast<float>(value); };
      EXPECT_EQ(got_u.values[n], rounded((at(u, kNy, i, j, k) + at(u, kNy, i + 1, j, k)) / 2)) << name;
      EXPECT_EQ(got_v.values[n], rounded((at(v, kNy + 1, i, j, k) + at(v, kNy + 1, i, j + 1, k)) / 2));
      EXPECT_EQ(got_w.values[n], rounded((at(w, kNy, i, j, k) + at(w, kNy, i, j, k + 1)) / 2));
      EXPECT_EQ(got_p.values[n], rounded(at(p, kNy, i, j, k)));
      EXPECT_EQ(got_phi.values[n], rounded(at(phi, kNy, i, j, k)));
    }
  };
  expect_plane("x_0", {kNz, kNy}, [](int k, int j) { return std::array{1, j, k}; });
  expect_plane("y_0", {kNz, kNx}, [](int k, int i) { return std::array{i, 0, k}; });
  expect_plane("y_1", {kNz, kNx}, [](int k, int i) { return std::array{i, kNy - 1, k}; });
  expect_plane("z_0", {kNy, kNx}, [](int j, int i) { return std::array{i, j, kNz - 1}; });
}

TEST_F(FilmTest, HoldTheHeightThatTheStatisticsTake) {
  Case definition = soft_wall();
  definition.run.planes = {};
  time::Setup setup(definition.physics, world_.get());
  time::State state = support::numbered_state(setup, 0);
  const auto& g = setup.grid;
  support::set_by_index(state.material.phi, g, kNy, [&](int i, int j, int k) {
    return j < 8 ? 0.0 : j == 8 ? 0.1 + 0.05 * ((i + 3 * k) % 17) : 1.0;
  });
  Film film(run_, definition, setup);
  ASSERT_FALSE(film.none());
  write_moment(film, state, setup);
  const Read height = read(run_.planes() / "planes-000000000.h5", "interface/height");
  ASSERT_EQ(height.shape, (std::vector<hsize_t>{kNz, kNx}));
  double sum = 0;
  for (int k = 0; k < kNz; ++k)
    for (int i = 0; i < kNx; ++i) {
      const double eta = height.values[static_cast<std::size_t>(k * kNx + i)];
      EXPECT_NEAR(eta, g.y_face[9] - (0.1 + 0.05 * ((i + 3 * k) % 17)) * g.dy[8], 3e-7);
      sum += eta;
    }
  const auto shape =
      statistics::shape_of(statistics::heights_of_interface(state.material, g), g, setup.decomposition);
  EXPECT_NEAR(sum / (kNx * kNz), shape.mean, 1e-7);
  EXPECT_GT(shape.rms, 0.02);
}

/// But for the grid and what HDF5 keeps for itself, which do not grow with the planes.
TEST_F(FilmTest, TheirSizeIsKnownFromTheCaseAlone) {
  std::int64_t more_of_last = 0;
  for (const int scale : {8, 16}) {
    Case definition = soft_wall();
    definition.physics = support::elastic_channel({scale * kNx, 8, 4, scale * kNz});
    time::Setup setup(definition.physics, world_.get());
    time::State state = time::state_at_rest(setup);
    state.step = scale;
    time::start(state, setup);
    Film film(run_, definition, setup);
    write_moment(film, state, setup);
    const auto more = static_cast<std::int64_t>(std::filesystem::file_size(run_.planes_of(scale))) -
                      film_moment_bytes(definition.physics, definition.run.planes);
    EXPECT_GT(more, 0);
    EXPECT_LT(more, 50000);
    if (more_of_last > 0) {
      EXPECT_NEAR(double(more), double(more_of_last), 1e4);
    }
    more_of_last = more;
  }
  EXPECT_EQ(film_moment_bytes(support::rigid_channel({24, 16, 0, 24}), {}), 0);
}

/// One rank alone writes the same state: the same bytes.
TEST_F(FilmTest, DoNotDependOnTheNumberOfRanks) {
  const Case definition = soft_wall();
  const auto write = [&](MPI_Comm comm, const RunFiles& run) {
    time::Setup setup(definition.physics, comm);
    time::State state = support::numbered_state(setup, 5);
    time::start(state, setup);
    Film film(run, definition, setup);
    write_moment(film, state, setup);
  };
  write(world_.get(), run_);
  if (world_.rank() == 0) {
    write(MPI_COMM_SELF, {folder_.path() / "alone"});
    const std::string alone = contents(folder_.path() / "alone" / "planes" / "planes-000000005.h5");
    EXPECT_GT(alone.size(), 5 * 4 * (kNz * kNy + 2 * kNz * kNx + kNy * kNx));
    EXPECT_TRUE(alone == contents(run_.planes() / "planes-000000005.h5"));
  }
}

TEST_F(FilmTest, OfARigidChannelHaveNoSolid) {
  Case definition;
  definition.id = support::kCaseId;
  definition.physics = support::rigid_channel({kNx, 8, 0, kNz});
  time::Setup setup(definition.physics, world_.get());
  EXPECT_TRUE(Film(run_, definition, setup).none());
  definition.run.planes.y = {1.01};
  time::State state = time::state_at_rest(setup);
  Film film(run_, definition, setup);
  write_moment(film, state, setup);
  const auto file = run_.planes() / "planes-000000000.h5";
  EXPECT_EQ(read(file, "y_0/position").values.at(0), 1.125);
  EXPECT_THROW(static_cast<void>(read(file, "y_0/phi")), std::runtime_error);
  EXPECT_THROW(static_cast<void>(read(file, "interface/height")), std::runtime_error);
}

/// What is appended reads as what is made anew.
TEST_F(FilmTest, StandInOneCollectionHoweverTheyCame) {
  const Case definition = soft_wall();
  time::Setup setup(definition.physics, world_.get());
  time::State state = time::state_at_rest(setup);
  const auto write = [&](Film& film, std::int64_t step) {
    state.step = step;
    state.time = 0.5 * static_cast<double>(step);
    write_moment(film, state, setup);
  };
  const auto collection = run_.planes() / "planes.xdmf";
  Film first(run_, definition, setup);
  for (const std::int64_t step : {0, 10, 20, 30}) write(first, step);
  if (world_.rank() == 0) std::ofstream(run_.planes() / "planes-000000007.h5") << "no moment";
  const std::string appended = contents(collection);
  std::size_t at = 0;
  for (const char* part : {"<Time Value=\"0\"/>", "Name=\"interface\"", "Dimensions=\"14 1 12\"",
                           "000000.h5:/interface/height", "Name=\"y_1\"", "<Time Value=\"15\"/>",
                           "planes-000000030.h5:/z_0/w", "</Grid>\n</Grid></Domain></Xdmf>\n"}) {
    const std::size_t found = appended.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << "\n" << appended;
    at = found;
  }
  Film resumed(run_, definition, setup);
  for (const std::int64_t step : {10, 20}) write(resumed, step);
  EXPECT_TRUE(contents(collection) == appended);
  MPI_Barrier(world_.get());
  if (world_.rank() == 0) std::ofstream(collection, std::ios::app) << "half a mom";
  MPI_Barrier(world_.get());
  write(resumed, 30);
  EXPECT_TRUE(contents(collection) == appended);
  MPI_Barrier(world_.get());
}

TEST_F(FilmTest, ThatCannotBeWrittenEndInOrder) {
  const Case definition = soft_wall();
  time::Setup setup(definition.physics, world_.get());
  const time::State state = time::state_at_rest(setup);
  if (world_.rank() == 0) std::ofstream(run_.planes()) << "a file where the folder belongs";
  MPI_Barrier(world_.get());
  Film film(run_, definition, setup);
  try {
    write_moment(film, state, setup);
    FAIL() << "written";
  } catch (const AgreedError& error) {
    EXPECT_EQ(error.code, ExitCode::kIoFailure);
  }
}

}  // namespace
}  // namespace softwall::output
