#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace softwall::campaign {

/// A process that cannot be mistaken for a later one with the same number: its start time and the boot it
/// belongs to are part of the name.
struct ProcessIdentity {
  std::string host;
  std::string boot_id;  ///< /proc/sys/kernel/random/boot_id
  pid_t pid = 0;
  std::uint64_t start_ticks = 0;  ///< clock ticks from boot to its start, field 22 of /proc/PID/stat
  bool operator==(const ProcessIdentity&) const = default;
};

/// The identity of process pid on this host. Throws std::runtime_error when there is no such process.
[[nodiscard]] ProcessIdentity identify(pid_t pid);
[[nodiscard]] ProcessIdentity this_process();

/// True also for a process that has ended but was not yet waited for.
[[nodiscard]] bool has_ended(pid_t pid);

/// 0 when there is no such process.
[[nodiscard]] pid_t parent_of(pid_t pid);

void to_json(nlohmann::json& json, const ProcessIdentity& process);
void from_json(const nlohmann::json& json, ProcessIdentity& process);

}  // namespace softwall::campaign
