#include "solver/run_directory/statistics_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <mpi.h>

#include <chrono>
#include <cstring>
#include <limits>
#include <thread>

#include "solver/run_directory/file_seal.hpp"
#include "solver/run_directory/hdf5_image.hpp"
#include "tests/analysis/samples.hpp"

namespace softwall::analysis {
namespace {

BlockStatistics awkward_statistics() {
  BlockStatistics s = samples::elastic_statistics({}, 5, 40);
  s.weight.back() = 0.7;  // a block still being filled
  samples::add_profile(s, "uv", Location::kFace, [](double y, std::size_t b) { return y / (3.0 + b); });
  s.profiles["uv"].values[3] = -0.0;
  s.profiles["uv"].values[4] = 4.9e-324;
  s.profiles["uv"].values[5] = std::numeric_limits<double>::quiet_NaN();
  s.series["wall_age"] = {1, 2, 3, 4, 1.0 / 3.0};
  s.meanings["wall_age"] = {"h/U_b", "a name of a later version"};
  return s;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void expect_same(const BlockStatistics& a, const BlockStatistics& b) {
  EXPECT_EQ(a.case_id, b.case_id);
  EXPECT_EQ(a.reynolds, b.reynolds);
  EXPECT_EQ(a.elastic, b.elastic);
  EXPECT_EQ(a.interface_y, b.interface_y);
  EXPECT_TRUE(same_bits(a.y_center, b.y_center) && same_bits(a.y_face, b.y_face));
  EXPECT_TRUE(same_bits(a.start, b.start) && same_bits(a.end, b.end) && same_bits(a.weight, b.weight));
  ASSERT_EQ(a.profiles.size(), b.profiles.size());
  for (const auto& [name, profile] : a.profiles) {
    ASSERT_TRUE(b.profiles.contains(name));
    EXPECT_EQ(profile.location, b.profiles.at(name).location);
    EXPECT_TRUE(same_bits(profile.values, b.profiles.at(name).values)) << name;
  }
  ASSERT_EQ(a.series.size(), b.series.size());
  for (const auto& [name, values] : a.series) EXPECT_TRUE(same_bits(values, b.series.at(name))) << name;
  ASSERT_EQ(a.meanings.size(), b.meanings.size());
  for (const auto& [name, meaning] : a.meanings) {
    EXPECT_EQ(meaning.unit, b.meanings.at(name).unit);
    EXPECT_EQ(meaning.description, b.meanings.at(name).description);
  }
}

std::string contents_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void put(const std::filesystem::path& path, const std::string& contents) {
  std::ofstream(path, std::ios::binary) << contents;
}

std::string complaint_about(const std::filesystem::path& path) {
  try {
    (void)read_statistics(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

class StatisticsFile : public testing::Test {
 protected:
  samples::ScratchFolder folder_;
  std::filesystem::path path_ = folder_.path() / "statistics.h5";
};

TEST_F(StatisticsFile, RoundTripKeepsEveryBit) {
  const BlockStatistics s = awkward_statistics();
  write_statistics(path_, s);
  expect_same(s, read_statistics(path_));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1)
      << "temporary left behind";
}

TEST_F(StatisticsFile, EqualStatisticsMakeEqualFiles) {
  write_statistics(path_, awkward_statistics());
  const std::string first = contents_of(path_);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's own time stamps count seconds
  write_statistics(path_, awkward_statistics());
  EXPECT_EQ(first, contents_of(path_));
}

TEST_F(StatisticsFile, HoldsNoBlocksBeforeTheFirstSample) {
  write_statistics(path_, samples::elastic_statistics({}, 0));
  EXPECT_EQ(read_statistics(path_).blocks(), 0U);
}

TEST_F(StatisticsFile, NeverInitialisesMpi) {
  write_statistics(path_, awkward_statistics());
  (void)read_statistics(path_);
  int initialised = 1;
  MPI_Initialized(&initialised);
  EXPECT_EQ(initialised, 0);
}

TEST_F(StatisticsFile, IsAnHdf5FileWithDescribedDatasets) {
  // As h5py or h5dump see it: through the file system, past the seal.
  write_statistics(path_, awkward_statistics());
  const Hdf5Id file(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open");
  for (const std::string name :
       {"/grid/y_center", "/blocks/weight", "/profiles/u", "/series/driving_gradient"}) {
    const Hdf5Id dataset(H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT), H5Dclose, name);
    for (const std::string attribute : {"unit", "description", "location"}) {
      EXPECT_FALSE(read_text_attribute(dataset.get(), attribute).empty()) << name << " " << attribute;
    }
  }
}

TEST_F(StatisticsFile, RefusesToWriteNonsense) {
  BlockStatistics s = awkward_statistics();
  s.series["driving_gradient"].pop_back();
  EXPECT_THROW(write_statistics(path_, s), std::runtime_error);
  s = awkward_statistics();
  s.meanings.clear();
  EXPECT_THROW(write_statistics(path_, s), std::runtime_error);
  s = awkward_statistics();
  s.y_face[3] = s.y_face[2];
  EXPECT_THROW(write_statistics(path_, s), std::runtime_error);
  s = awkward_statistics();
  s.elastic = false;  // then there is nothing above interface_y
  EXPECT_THROW(write_statistics(path_, s), std::runtime_error);
  s = awkward_statistics();
  s.interface_y = 0.0;
  EXPECT_THROW(write_statistics(path_, s), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(StatisticsFile, FailedWriteKeepsTheOldFile) {
  write_statistics(path_, awkward_statistics());
  BlockStatistics bad = awkward_statistics();
  bad.weight.clear();
  EXPECT_THROW(write_statistics(path_, bad), std::runtime_error);
  expect_same(awkward_statistics(), read_statistics(path_));
  EXPECT_ANY_THROW(write_statistics(folder_.path() / "missing" / "statistics.h5", awkward_statistics()));
}

TEST_F(StatisticsFile, NamesWhatIsWrong) {
  EXPECT_NE(complaint_about(path_).find("statistics.h5 cannot be opened"), std::string::npos);
  put(path_, "");
  EXPECT_NE(complaint_about(path_).find("is only 0 bytes"), std::string::npos) << complaint_about(path_);
  put(path_, std::string(4096, 'x'));
  EXPECT_NE(complaint_about(path_).find("not a statistics file"), std::string::npos);
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  EXPECT_NE(complaint_about(path_), "");
}

TEST_F(StatisticsFile, AnyDamageIsSeen) {
  write_statistics(path_, awkward_statistics());
  const std::string good = contents_of(path_);
  for (std::size_t i = 0; i < 200; ++i) {
    const std::size_t at = i * good.size() / 200;
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x20);
    put(path_, bad);
    EXPECT_NE(complaint_about(path_), "") << "flipped byte " << at;
    put(path_, good.substr(0, at));
    EXPECT_NE(complaint_about(path_), "") << "cut at " << at;
  }
}

// Sealed correctly, so that HDF5 sees it, but not what a statistics file holds.
TEST_F(StatisticsFile, WellSealedNonsenseIsRefused) {
  put(path_, seal_for("not HDF5") + "not HDF5");
  EXPECT_NE(complaint_about(path_).find("not an HDF5 file"), std::string::npos) << complaint_about(path_);

  const std::string empty = [] {
    const Hdf5Id file = create_image();
    return image_bytes(file);
  }();
  put(path_, seal_for(empty) + empty);
  EXPECT_NE(complaint_about(path_).find("case_id"), std::string::npos) << complaint_about(path_);

  const std::string short_series = [] {
    const Hdf5Id file = create_image();
    write_attribute(file.get(), "case_id", std::string("a"));
    write_attribute(file.get(), "reynolds", 2800.0);
    write_attribute(file.get(), "elastic", 0.0);
    write_attribute(file.get(), "interface_y", 2.0);
    const Hdf5Id grid = create_group(file.get(), "grid");
    (void)write_dataset(grid.get(), "y_center", {0.5, 1.5}, {2});
    (void)write_dataset(grid.get(), "y_face", {0.0, 1.0, 2.0}, {1, 3});
    return image_bytes(file);
  }();
  put(path_, seal_for(short_series) + short_series);
  EXPECT_NE(complaint_about(path_).find("y_face is not one-dimensional"), std::string::npos)
      << complaint_about(path_);
}

}  // namespace
}  // namespace softwall::analysis
