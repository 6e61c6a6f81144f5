#include "campaign/runner/campaign_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>

#include "campaign/system/file_system.hpp"
#include "campaign/system/own_file.hpp"
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

FileDescriptor open_lock_file(const std::filesystem::path& file) {
  // It is closed on exec: a surviving solver must not keep the lock of a dead runner.
  FileDescriptor opened = open_own_file(file, O_RDWR, S_IRUSR | S_IWUSR);
  // Whoever can open it can lock it. It may be from a time when all could.
  struct stat status {};
  if (fstat(opened.get(), &status) == 0 && status.st_uid == geteuid())
    fchmod(opened.get(), S_IRUSR | S_IWUSR);
  return opened;
}

/// Those who only ask whether the file is locked hold a lock themselves for that moment: it is waited for.
bool lock_for_good(int file) {
  constexpr int kMostTries = 10;
  for (int i = 0; i < kMostTries; ++i) {
    if (flock(file, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno != EWOULDBLOCK && errno != EINTR) return false;
    usleep(20'000);
  }
  errno = EWOULDBLOCK;
  return false;
}

/// Who waited for a lock may have got that of a file which its holder has removed meanwhile.
bool is_the_file_named(const std::filesystem::path& path, int file) {
  struct stat named {
  }, held{};
  return stat(path.c_str(), &named) == 0 && fstat(file, &held) == 0 && named.st_dev == held.st_dev &&
         named.st_ino == held.st_ino;
}

}  // namespace

CampaignLock::CampaignLock(const std::filesystem::path& folder) : path_(lock_file(folder)) {
  std::error_code unknown;
  made_ = !std::filesystem::exists(std::filesystem::symlink_status(path_, unknown));
  do {
    file_ = open_lock_file(path_);
    if (!lock_for_good(file_.get())) break;
    if (!is_the_file_named(path_, file_.get())) continue;
    write_owner(file_.get());
    return;
  } while (true);
  const int error = errno;
  const auto owner = read_owner(file_.get());
  if (error != EWOULDBLOCK) {
    throw std::runtime_error("cannot lock " + path_.string() + ": " + std::strerror(error));
  }
  throw CampaignOwned("this campaign is already being run by " +
                      (owner ? owner->describe() : std::string("another softwall")) +
                      "; nothing was changed");
}

void CampaignLock::leave_no_trace() {
  std::error_code stays;  // does no harm
  if (made_ && is_the_file_named(path_, file_.get())) std::filesystem::remove(path_, stays);
}

std::optional<std::string> living_owner(const std::filesystem::path& folder) {
  const FileDescriptor file(open(lock_file(folder).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (!file || flock(file.get(), LOCK_SH | LOCK_NB) == 0 || errno != EWOULDBLOCK) return std::nullopt;
  const auto owner = read_owner(file.get());
  return owner ? owner->describe() : "another softwall";
}

bool owner_is_unknown(const std::filesystem::path& folder) {
  return lock_state(lock_file(folder)) == LockState::kUnknown;
}

}  // namespace softwall::campaign
