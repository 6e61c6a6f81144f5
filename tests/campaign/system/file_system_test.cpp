#include "campaign/system/file_system.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <system_error>

#include "solver/case/file_descriptor.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/without_permission.hpp"

namespace softwall::campaign::tests {
namespace {

TEST(JournalModeTest, TheLogIsForKnownLocalDisksOnly) {
  constexpr long kExt4 = 0xEF53, kXfs = 0x58465342, kTmpfs = 0x01021994;
  for (const long local : {kExt4, kXfs, kTmpfs}) {
    EXPECT_EQ(journal_mode_for_type(local), JournalMode::kWriteAheadLog) << std::hex << local;
  }
  constexpr long kNfs = 0x6969, kLustre = 0x0BD00BD0, kCifs = 0xFF534D42, kSmb2 = 0xFE534D42,
                 kFuse = 0x65735546, kGpfs = 0x47504653, kCeph = 0x00C36400, kOverlay = 0x794C7630,
                 kUnheardOf = 0x12345678;
  for (const long remote : {kNfs, kLustre, kCifs, kSmb2, kFuse, kGpfs, kCeph, kOverlay, kUnheardOf}) {
    EXPECT_EQ(journal_mode_for_type(remote), JournalMode::kRollback) << std::hex << remote;
  }
  EXPECT_THROW((void)journal_mode_for("/no/such/place"), std::system_error);
  EXPECT_EQ(journal_mode_for("/proc"), JournalMode::kRollback);
}

TEST(LockState, OfAFileOfAnotherUserIsUnknown) {
  const test::TemporaryFolder folder;
  folder.write("lock", "");
  const auto file = folder.path() / "lock";
  EXPECT_EQ(lock_state(file), LockState::kFree);
  EXPECT_EQ(lock_state(folder.path() / "none"), LockState::kFree);
  {
    const FileDescriptor holder(open(file.c_str(), O_RDONLY | O_CLOEXEC));
    ASSERT_EQ(flock(holder.get(), LOCK_EX), 0);
    EXPECT_EQ(lock_state(file), LockState::kHeld);
  }
  const test::WithoutPermission nobody(file);
  EXPECT_EQ(lock_state(file), LockState::kUnknown);
}

}  // namespace
}  // namespace softwall::campaign::tests
