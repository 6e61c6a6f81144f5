#include "campaign/store/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {
namespace {

namespace fs = std::filesystem;

std::string contents_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(WriteOutput, ReplacesAPlainFileAndKeepsItsPermissions) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "table.csv";
  write_output(file, "one");
  EXPECT_EQ(contents_of(file), "one");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  write_output(file, "two");
  EXPECT_EQ(contents_of(file), "two");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(WriteOutput, GoesThroughALink) {
  const test::TemporaryFolder folder;
  const fs::path target = folder.path() / "target", link = folder.path() / "link";
  fs::create_symlink("target", link);
  write_output(link, "new");  // the link points to nothing yet
  write_output(link, "newer");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(contents_of(target), "newer");
}

TEST(WriteOutput, LeavesTheOtherNamesOfAFile) {
  const test::TemporaryFolder folder;
  const fs::path one = folder.path() / "one", other = folder.path() / "other";
  write_output(one, "a longer text");
  fs::create_hard_link(one, other);
  write_output(one, "short");
  EXPECT_EQ(contents_of(other), "short");
}

TEST(WriteOutput, FeedsAPipe) {
  const test::TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = contents_of(pipe); });
  write_output(pipe, "through");
  reader.join();
  EXPECT_EQ(read, "through");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(WriteOutput, LeavesADeviceADevice) {
  const test::TemporaryFolder folder;
  const fs::path device = folder.path() / "null";
  if (mknod(device.c_str(), S_IFCHR | 0600, makedev(1, 3)) != 0) GTEST_SKIP() << "making a device needs root";
  try {
    write_output(device, "gone");
  } catch (const std::system_error&) {
    // the folder's file system may not let devices be opened; what matters is that it stays one
  }
  EXPECT_TRUE(fs::is_character_file(device));
}

TEST(WriteOutput, SaysThatADeviceIsFull) {
  EXPECT_THROW(write_output("/dev/full", "text"), std::system_error);
  EXPECT_THROW(write_output("/dev", "text"), std::system_error);
}

}  // namespace
}  // namespace softwall::campaign::tests
