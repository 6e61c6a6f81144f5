#include "campaign/system/own_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <system_error>

#include "solver/case/bad_input.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

TEST(OwnFile, IsMadeWhereThereIsNone) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(open_own_file(folder.path() / "log", O_WRONLY | O_APPEND, 0600));
  EXPECT_TRUE(open_own_file(folder.path() / "log", O_WRONLY | O_APPEND, 0600)) << "and opened again";
  EXPECT_THROW(open_own_file(folder.path() / "none" / "log", O_WRONLY, 0600), std::system_error);
}

TEST(OwnFile, IsNoLinkNoFolderAndNoPipe) {
  const test::TemporaryFolder folder;
  const auto target = folder.write("precious", "text");
  std::filesystem::create_symlink(target, folder.path() / "link");
  std::filesystem::create_symlink(folder.path() / "nowhere", folder.path() / "dangling");
  std::filesystem::create_directory(folder.path() / "folder");
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "dangling", "folder", "pipe"})
    EXPECT_THROW(open_own_file(folder.path() / name, O_WRONLY | O_APPEND, 0600), BadInput) << name;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "nowhere"));
}

}  // namespace
}  // namespace softwall::campaign
