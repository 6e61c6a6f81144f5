#include "campaign/system/work_marks.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>

#include "campaign/system/process_identity.hpp"

namespace softwall::campaign {
namespace {

std::string environment_now(pid_t pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/environ", std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

bool is_own(pid_t pid) {
  struct stat status {};
  return stat(("/proc/" + std::to_string(pid)).c_str(), &status) == 0 && status.st_uid == geteuid();
}

/// The environment of a process of this user, or nothing once it has ended. While a process becomes another
/// program it has none for a moment. That moment is waited for, because the process may be a rank. (A thread
/// of the kernel has none either, and no session.)
std::string environment_of(pid_t pid) {
  constexpr int kMostTries = 20;
  std::string environment = environment_now(pid);
  for (int tries = 1; environment.empty() && tries < kMostTries; ++tries) {
    if (getsid(pid) <= 0 || !is_own(pid) || has_ended(pid)) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    environment = environment_now(pid);
  }
  return environment;
}

std::optional<pid_t> number_in(std::string_view text) {
  pid_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || rest != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The block is a sequence of NAME=value, each ended by a zero byte.
std::optional<std::string> value_in(std::string_view environment, const std::string& name) {
  const std::string begin = name + "=";
  while (!environment.empty()) {
    const std::string_view entry = environment.substr(0, environment.find('\0'));
    if (entry.starts_with(begin)) return std::string(entry.substr(begin.size()));
    environment.remove_prefix(std::min(entry.size() + 1, environment.size()));
  }
  return std::nullopt;
}

/// Where process pid works; nothing when it is none of ours.
std::optional<std::string> workplace_of(pid_t pid) {
  const std::string environment = environment_of(pid);
  const auto directory = value_in(environment, kRunDirectoryVariable);
  if (!directory) return std::nullopt;
  const auto session = value_in(environment, kSessionVariable);
  return session && number_in(*session) == getsid(pid) ? directory : std::nullopt;
}

std::vector<pid_t> other_processes() {
  const pid_t self = getpid();
  std::vector<pid_t> found;
  std::error_code ignored;  // processes end while we look; what cannot be read is not ours
  for (std::filesystem::directory_iterator item("/proc", ignored), end; item != end;
       item.increment(ignored)) {
    const auto pid = number_in(item->path().filename().native());
    if (pid && *pid != self) found.push_back(*pid);
  }
  return found;
}

}  // namespace

std::filesystem::path canonical_run_directory(const std::filesystem::path& run_directory) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(run_directory));
}

std::string run_directory_mark(const std::filesystem::path& run_directory) {
  return std::string(kRunDirectoryVariable) + "=" + canonical_run_directory(run_directory).string();
}

ProcessesAtWork ProcessesAtWork::look() {
  ProcessesAtWork work;
  for (const pid_t pid : other_processes()) work.add(pid);
  return work;
}

ProcessesAtWork ProcessesAtWork::look_in(const std::set<pid_t>& sessions) {
  ProcessesAtWork work;
  for (const pid_t pid : other_processes())
    if (sessions.contains(getsid(pid))) work.add(pid);
  return work;
}

void ProcessesAtWork::add(pid_t pid) {
  if (const auto directory = workplace_of(pid)) by_directory_[*directory].push_back(pid);
}

std::vector<pid_t> ProcessesAtWork::in(const std::filesystem::path& run_directory) const {
  if (nobody()) return {};
  const auto found = by_directory_.find(canonical_run_directory(run_directory).string());
  return found == by_directory_.end() ? std::vector<pid_t>() : found->second;
}

}  // namespace softwall::campaign
