#include "campaign/runner/progress_line.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "solver/case/file_descriptor.hpp"
#include "tests/campaign/core/examples.hpp"
#include "tests/support/temporary_folder.hpp"

/// How often the line of progress is made.
namespace softwall::campaign {
namespace {

/// A terminal in the place of standard error, for as long as this lives.
class Terminal {
 public:
  Terminal() : screen_(posix_openpt(O_RDWR | O_NOCTTY)), before_(dup(STDERR_FILENO)) {
    grantpt(screen_.get());
    unlockpt(screen_.get());
    const FileDescriptor terminal(open(ptsname(screen_.get()), O_RDWR | O_NOCTTY));
    dup2(terminal.get(), STDERR_FILENO);
  }
  ~Terminal() { dup2(before_.get(), STDERR_FILENO); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// What has been drawn since the last call: all that comes before a sign of our own.
  [[nodiscard]] std::string drawn() const {
    std::string text;
    if (write(STDERR_FILENO, "#", 1) != 1) return text;
    for (char c = '\0'; read(screen_.get(), &c, 1) == 1 && c != '#';) text += c;
    return text;
  }

 private:
  FileDescriptor screen_, before_;
};

class ProgressLineTest : public ::testing::Test {
 protected:
  /// The precursor at work: it has come to this time, with a thousand seconds for each step of 0.1.
  void report(double time) {
    Status status;
    status.time = time;
    status.dt = 0.1;
    status.seconds_per_step = 1000;
    status.step = ++steps_;
    const LaunchRequest request{.case_id = book_.campaign().cases.front().definition.id, .run_directory = ""};
    working_.try_emplace(request.case_id, request, "", 0.0).first->second.report(status, 0.0);
  }
  std::string shown_at(double now) {
    line_.show(book_, working_, now);
    return terminal_.drawn();
  }

  Terminal terminal_;
  test::TemporaryFolder folder_;
  Progress progress_{""};
  Store store_ = Store::open(folder_.path(), OpenMode::kCreate);
  CaseBook book_{tests::campaign_of(tests::elastic_campaign()), folder_.path(), store_, progress_};
  std::map<std::string, AttemptWatch> working_;
  ProgressLine line_{progress_};
  int steps_ = 0;
};

TEST_F(ProgressLineTest, IsDrawnOnceASecondHoweverOftenItMayBe) {
  report(1);
  EXPECT_NE(shown_at(100.0).find("0/5 finished"), std::string::npos);
  EXPECT_EQ(shown_at(100.2), "");
  EXPECT_EQ(shown_at(100.9), "");
  EXPECT_NE(shown_at(101.0), "");
}

TEST_F(ProgressLineTest, TheTimeThatIsLeftIsEstimatedLessOften) {
  const auto left = [](const std::string& line) { return line.substr(line.rfind('|') + 1); };
  report(1);
  const std::string first = shown_at(100.0);
  report(0.8 * book_.campaign().cases.front().definition.run.end_time);
  const std::string second = shown_at(101.0);
  EXPECT_NE(second, first) << "the line is another one";
  EXPECT_EQ(left(second), left(first));
  EXPECT_NE(left(shown_at(105.0)), left(first));
}

}  // namespace
}  // namespace softwall::campaign
