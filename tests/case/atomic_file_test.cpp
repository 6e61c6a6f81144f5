#include "solver/case/atomic_file.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

#include "tests/case/examples.hpp"

namespace softwall {
namespace {

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::ptrdiff_t entries(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

TEST(AtomicFile, WritesAndReplacesAndLeavesNothingElse) {
  const tests::TemporaryFolder folder;
  for (const std::string text : {"first", "", "a longer third\n"}) {
    write_atomically(folder / "file", text);
    EXPECT_EQ(contents(folder / "file"), text);
    EXPECT_EQ(entries(folder.path()), 1);
  }
  write_atomically(folder / "file", std::string("bytes\0within", 12), Durability::kQuick);
  EXPECT_EQ(contents(folder / "file").size(), 12U);
}

TEST(AtomicFile, ANewOneReplacesNone) {
  const tests::TemporaryFolder folder;
  EXPECT_TRUE(write_new_atomically(folder / "file", "first"));
  EXPECT_FALSE(write_new_atomically(folder / "file", "second"));
  EXPECT_EQ(contents(folder / "file"), "first");
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(AtomicFile, FailureKeepsTheOldOneAndSaysWhich) {
  const tests::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken");
  std::ofstream(folder / "taken" / "inside") << "kept";
  try {
    write_atomically(folder / "taken", "new");
    FAIL() << "a folder was replaced by a file";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("taken"), std::string::npos) << error.what();
  }
  EXPECT_EQ(contents(folder / "taken" / "inside"), "kept");
  EXPECT_EQ(entries(folder.path()), 1);  // no temporary file left
}

TEST(AtomicFile, MissingFolderIsAnError) {
  const tests::TemporaryFolder folder;
  EXPECT_THROW(write_atomically(folder / "absent" / "file", "text"), std::system_error);
}

TEST(AtomicFile, ReadersNeverSeeHalfAFile) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder / "file";
  write_atomically(file, std::string(100000, 'a'), Durability::kQuick);
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (int i = 0; i < 300; ++i)
      write_atomically(file, std::string(100000, static_cast<char>('a' + i % 26)), Durability::kQuick);
    done = true;
  });
  int torn = 0;
  while (!done) {
    const std::string text = contents(file);
    if (text.size() != 100000 || text.find_first_not_of(text[0]) != std::string::npos) ++torn;
  }
  writer.join();
  EXPECT_EQ(torn, 0);
}

TEST(AtomicFile, PublishesWhatALibraryWrote) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "data.tmp") << "data";
  std::ofstream(folder / "data.h5") << "older";
  publish_file(folder / "data.tmp", folder / "data.h5");
  EXPECT_EQ(contents(folder / "data.h5"), "data");
  EXPECT_FALSE(std::filesystem::exists(folder / "data.tmp"));
  EXPECT_THROW(publish_file(folder / "data.tmp", folder / "data.h5"), std::system_error);
  EXPECT_EQ(contents(folder / "data.h5"), "data");
}

}  // namespace
}  // namespace softwall
