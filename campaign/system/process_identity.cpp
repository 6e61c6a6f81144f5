#include "campaign/system/process_identity.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {
namespace {

std::string read_whole(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct ProcessState {
  char letter = 'Z';
  pid_t parent = 0;
  std::uint64_t start_ticks = 0;
};

/// Fields 3, 4 and 22 of /proc/PID/stat; the name in field 2 may hold blanks and brackets, so count from its
/// end.
std::optional<ProcessState> read_state(pid_t pid) {
  const std::string text = read_whole("/proc/" + std::to_string(pid) + "/stat");
  const auto name_end = text.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(text.substr(name_end + 1));
  ProcessState state;
  std::string skipped;
  fields >> state.letter >> state.parent;
  for (int field = 5; field < 22; ++field) fields >> skipped;
  fields >> state.start_ticks;
  return fields ? std::optional(state) : std::nullopt;
}

std::string boot_id() {
  std::string id = read_whole("/proc/sys/kernel/random/boot_id");
  std::erase(id, '\n');
  return id;
}

}  // namespace

ProcessIdentity identify(pid_t pid) {
  const auto state = read_state(pid);
  if (!state) throw std::runtime_error("there is no process " + std::to_string(pid));
  return {host_name(), boot_id(), pid, state->start_ticks};
}

ProcessIdentity this_process() { return identify(getpid()); }

bool has_ended(pid_t pid) {
  const auto state = read_state(pid);
  return !state || state->letter == 'Z';
}

pid_t parent_of(pid_t pid) {
  const auto state = read_state(pid);
  return state ? state->parent : 0;
}

void to_json(nlohmann::json& json, const ProcessIdentity& process) {
  json = {{"host", process.host},
          {"boot_id", process.boot_id},
          {"pid", process.pid},
          {"start_ticks", process.start_ticks}};
}

void from_json(const nlohmann::json& json, ProcessIdentity& process) {
  json.at("host").get_to(process.host);
  json.at("boot_id").get_to(process.boot_id);
  json.at("pid").get_to(process.pid);
  json.at("start_ticks").get_to(process.start_ticks);
}

}  // namespace softwall::campaign
