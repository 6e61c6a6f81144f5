#include "campaign/launch/trial.hpp"

#include <stdlib.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "campaign/launch/scratch.hpp"
#include "campaign/system/clock.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {
namespace {

constexpr double kLongestTrialSeconds = 60.0;
constexpr std::size_t kLongestText = 1000;

/// A run directory for the moment.
class TrialFolder {
 public:
  TrialFolder() {
    std::string name = temporary_root() / "softwall-trial-XXXXXX";
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("cannot make the temporary directory " + name + ": " + std::strerror(errno));
    run_.directory = name;
  }
  ~TrialFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(run_.directory, ignored);
  }
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;
  [[nodiscard]] const RunFiles& run() const { return run_; }

 private:
  RunFiles run_;
};

/// What was said, in one line, without the rulers that Open MPI draws around it.
std::string words_in(const std::filesystem::path& log) {
  std::ifstream in(log);
  std::string text;
  for (std::string line; std::getline(in, line) && text.size() < kLongestText;) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || line.find_first_not_of("-=* \t") == std::string::npos) continue;
    text += (text.empty() ? "" : " ") + line.substr(begin);
  }
  return text.substr(0, kLongestText);
}

std::string try_in(const RunFiles& run, Launcher& launcher, int ranks) {
  static_cast<void>(launcher.start({"trial", run.directory, 0, ranks, std::nullopt}));
  const double end = monotonic_seconds() + kLongestTrialSeconds;
  std::vector<EndedAttempt> ended;
  while (ended.empty() && monotonic_seconds() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ended = launcher.collect();
  }
  const std::string words = words_in(run.log());
  const std::string said = words.empty() ? "" : ": " + words;
  if (ended.empty()) return "it has not ended after a minute" + said;
  const int exit_code = ended.front().exit_code.value_or(-1);
  if (exit_code != 0) return "exit status " + std::to_string(exit_code) + said;
  const bool has_started = words.find(run.directory.string()) != std::string::npos;
  return has_started ? "" : "it ends at once and starts nothing" + said;
}

}  // namespace

std::string trouble_with_launch(Launcher& launcher, int ranks) {
  try {
    const TrialFolder folder;
    return try_in(folder.run(), launcher, ranks);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace softwall::campaign
