#include "campaign/commands/preflight.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

#include "campaign/observe/observe.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/checkpoint_size.hpp"
#include "solver/case/file_descriptor.hpp"
#include "solver/case/programs.hpp"

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& where, const std::string& given, const std::string& allowed) {
  throw BadInput(where, {{"", given, allowed}});
}

bool is_program(const fs::path& file) {
  std::error_code unreadable;
  return fs::is_regular_file(file, unreadable) && access(file.c_str(), X_OK) == 0;
}

fs::path find_solver() {
  if (const char* chosen = std::getenv("SOFTWALL_DNS"); chosen != nullptr && *chosen != '\0') {
    if (!is_program(chosen)) refuse("SOFTWALL_DNS", chosen, "an executable softwall-dns");
    return fs::absolute(chosen);
  }
  const fs::path beside = solver_program(folder_of_this_program(), Precision::kDouble);
  if (!is_program(beside)) {
    refuse("softwall-dns", "no executable " + beside.string(),
           "the solver built beside softwall, or named by the environment variable SOFTWALL_DNS");
  }
  return beside;
}

fs::path find_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::absolute(fs::path(folder) / name);
    if (is_program(file)) return file;
  }
  refuse(name, "not found on the PATH", "Open MPI (on Debian: apt install openmpi-bin)");
}

std::string gigabytes(double bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g GB", bytes / 1e9);
  return text.data();
}

}  // namespace

ProcessLauncher::Programs find_programs() { return {find_on_path("mpirun"), find_solver()}; }

void require_precisions(const Campaign& campaign, const fs::path& solver) {
  const fs::path folder = fs::canonical(solver).parent_path();
  for (const CampaignCase& one : campaign.cases) {
    const Precision precision = one.definition.physics.precision;
    const fs::path program = solver_program(folder, precision);
    if (precision == Precision::kDouble || is_program(program)) continue;
    refuse("physics.precision " + name_of(precision), "no executable " + program.string(),
           "the solver of that precision, built beside softwall-dns");
  }
}

void require_writable(const fs::path& folder) {
  const fs::path probe = folder / (".softwall-" + std::to_string(getpid()));
  const FileDescriptor file(open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (!file)
    refuse(folder.string(), std::string("cannot be written: ") + std::strerror(errno), "a writable folder");
  unlink(probe.c_str());
}

void require_disk_space(const Campaign& campaign, const fs::path& folder) {
  double needed = 0;
  for (const CampaignCase& one : campaign.cases) {
    const Observation seen = observe(one, run_files(folder, one));
    if (seen.newest_checkpoint || seen.state == CaseState::kFinished) continue;  // its share is already there
    // One more than is kept: the oldest goes only when the newest is complete.
    needed += static_cast<double>(checkpoint_field_bytes(one.definition.physics)) *
              (one.definition.run.keep_checkpoints + 1);
  }
  const double available = static_cast<double>(fs::space(folder).available);
  if (needed > available) {
    refuse(folder.string(), gigabytes(available) + " free on its disk",
           "the " + gigabytes(needed) + " that the checkpoints of this campaign take");
  }
}

}  // namespace softwall::campaign
