#include "campaign/runner/campaign_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>

#include "campaign/system/process_identity.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {
namespace {

std::filesystem::path lock_file(const std::filesystem::path& folder) { return folder / "campaign.lock"; }

struct Owner {
  ProcessIdentity process;
  std::string since;
  [[nodiscard]] std::string describe() const {
    return "softwall on " + process.host + ", process " + std::to_string(process.pid) + ", started " + since;
  }
};

std::optional<Owner> read_owner(int file) {
  std::array<char, 1024> text{};
  const ssize_t length = pread(file, text.data(), text.size(), 0);
  if (length <= 0) return std::nullopt;
  try {
    const auto record = nlohmann::json::parse(text.data(), text.data() + length);
    return Owner{record.at("process").get<ProcessIdentity>(), record.at("since").get<std::string>()};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

void write_owner(int file) {
  const std::string text =
      nlohmann::json{{"format", 1}, {"process", this_process()}, {"since", utc_now()}}.dump() + "\n";
  // Informative only: a short or failed write leaves a holder that cannot be named, not a wrong lock.
  if (ftruncate(file, 0) == 0 && pwrite(file, text.data(), text.size(), 0) > 0) fsync(file);
}

}  // namespace

CampaignLock::CampaignLock(const std::filesystem::path& folder) {
  // O_CLOEXEC: a surviving solver must not keep the lock of a dead runner.
  file_ = FileDescriptor(open(lock_file(folder).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!file_) {
    throw std::runtime_error("cannot write in the campaign folder " + folder.string() + ": " +
                             std::strerror(errno));
  }
  if (flock(file_.get(), LOCK_EX | LOCK_NB) == 0) {
    write_owner(file_.get());
    return;
  }
  const int error = errno;
  const auto owner = read_owner(file_.get());
  if (error != EWOULDBLOCK) {
    throw std::runtime_error("cannot lock " + lock_file(folder).string() + ": " + std::strerror(error));
  }
  throw CampaignOwned("this campaign is already being run by " +
                      (owner ? owner->describe() : std::string("another softwall")) +
                      "; nothing was changed");
}

std::optional<std::string> living_owner(const std::filesystem::path& folder) {
  const FileDescriptor file(open(lock_file(folder).c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return std::nullopt;
  const auto owner = read_owner(file.get());
  return owner && is_alive(owner->process) ? std::optional(owner->describe()) : std::nullopt;
}

}  // namespace softwall::campaign
