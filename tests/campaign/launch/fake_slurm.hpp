#pragma once

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "campaign/launch/slurm_queue.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::test {

/// Shell scripts in the place of Slurm's commands, first on the PATH for as long as this lives. The queue is
/// a file of squeue's lines, which a test changes as it likes; every call is written down.
class FakeSlurm {
 public:
  FakeSlurm() : path_(std::getenv("PATH")) {
    setenv("PATH", (folder_.path() / "bin:").string().append(path_).c_str(), 1);
    play("squeue", "cat queue");
    play("scancel", "");
    play("sinfo", "exit 1");
    play("sacct", "echo 'Slurm accounting storage is disabled' >&2; exit 1");
    play("sbatch", kAccept + "echo $number");
    set_queue({});
  }
  ~FakeSlurm() { setenv("PATH", path_.c_str(), 1); }
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  /// In a script of sbatch: the job is in the queue from here on.
  inline static const std::string kAccept =
      "for word in \"$@\"; do case $word in --job-name=*) name=${word#--job-name=};; esac; done\n"
      "number=$(wc -l < sbatch.calls); echo \"$number|PENDING|0|Priority|$name|\" >> queue\n";

  void play(const std::string& program, const std::string& body) const {
    folder_.write_script("bin/" + program, "cd '" + folder_.path().string() + "'; echo \"$*\" >> " + program +
                                               ".calls\n" + body + "\n");
  }
  void set_queue(const std::vector<std::string>& lines) const {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    folder_.write("queue", text);
  }
  [[nodiscard]] std::vector<std::string> queue() const { return lines_of("queue"); }
  /// Gives every job in the queue another state, and a raw exit status.
  void move_all(const std::string& state, int status = 0) const {
    std::vector<std::string> moved;
    for (const std::string& line : queue()) {
      const auto number = line.substr(0, line.find('|'));
      const auto name = line.substr(line.rfind('|', line.size() - 2) + 1);
      moved.push_back(number + "|" + state + "|" + std::to_string(status) + "|None|" + name);
    }
    set_queue(moved);
  }
  /// Arguments of every call so far.
  [[nodiscard]] std::vector<std::string> calls(const std::string& program) const {
    return lines_of(program + ".calls");
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  [[nodiscard]] std::vector<std::string> lines_of(const std::string& name) const {
    std::ifstream in(folder_.path() / name);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }

  TemporaryFolder folder_;
  std::string path_;
};

/// Nobody waits in a test longer than it has to.
inline constexpr campaign::SlurmPace kQuickPace{.shortest = 0.0,
                                                .longest = 0.0,
                                                .longest_silence = 0.0,
                                                .answer = 5.0,
                                                .doubt = 0.3,
                                                .quiet = 0.3,
                                                .gathering = 0.5,
                                                .submitting = 5.0};

}  // namespace softwall::test
