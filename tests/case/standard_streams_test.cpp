#include "solver/case/standard_streams.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/child_process.hpp"

namespace softwall {
namespace {

/// The number of the first file that a program opens which was started with these descriptors closed.
int first_file_after_closing(std::initializer_list<int> descriptors) {
  test::ChildProcess program([=] {
    for (const int descriptor : descriptors) close(descriptor);
    open_standard_streams();
    return open("/dev/null", O_RDONLY);
  });
  return WEXITSTATUS(program.wait());
}

TEST(StandardStreams, NoFileGetsTheNumberOfOneThatWasClosed) {
  EXPECT_GT(first_file_after_closing({2}), 2);
  EXPECT_GT(first_file_after_closing({1}), 2);
  EXPECT_GT(first_file_after_closing({0, 1, 2}), 2);
}

TEST(StandardStreams, AnOutputThatNobodyReceivesIsAnError) {
  test::ChildProcess program([] {
    close(STDOUT_FILENO);
    open_standard_streams();
    return write(STDOUT_FILENO, "x", 1) < 0 && write(STDERR_FILENO, "", 1) == 1 ? 0 : 1;
  });
  EXPECT_EQ(WEXITSTATUS(program.wait()), 0);
}

}  // namespace
}  // namespace softwall
