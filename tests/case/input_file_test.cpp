#include "solver/case/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/case/examples.hpp"

namespace softwall {
namespace {

std::string complaint(const std::filesystem::path& path, std::size_t limit = kInputFileLimit) {
  return tests::complaint([&] { return read_input_file(path, limit); });
}

TEST(InputFile, ComesBackWhole) {
  const tests::TemporaryFolder folder;
  std::string text(200000, 'x');
  text[70000] = '\0';
  std::ofstream(folder / "file", std::ios::binary) << text;
  EXPECT_EQ(read_input_file(folder / "file"), text);
  EXPECT_EQ(read_input_file(folder / "file", 200000), text);
  EXPECT_NE(complaint(folder / "file", 199999).find("larger than"), std::string::npos);
}

TEST(InputFile, OnlyRegularFilesAreRead) {
  const tests::TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  std::filesystem::create_symlink(folder / "loop", folder / "loop");
  EXPECT_NE(complaint(folder / "absent").find("cannot be opened"), std::string::npos);
  EXPECT_NE(complaint(folder.path()).find("directory"), std::string::npos);
  EXPECT_NE(complaint(folder / "fifo").find("not a regular file"), std::string::npos);  // and does not block
  EXPECT_NE(complaint("/dev/zero").find("not a regular file"), std::string::npos);
  EXPECT_NE(complaint(folder / "loop").find("cannot be opened"), std::string::npos);
}

}  // namespace
}  // namespace softwall
