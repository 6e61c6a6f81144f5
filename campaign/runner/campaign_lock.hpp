#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "solver/case/file_descriptor.hpp"

namespace softwall::campaign {

/// Another runner works on this campaign; the message names its host, process and start.
struct CampaignOwned : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One runner per campaign. The operating system's lock on <folder>/campaign.lock decides and dies with its
/// holder, so nothing is ever unlocked by hand; the record inside is only there to name the holder.
class CampaignLock {
 public:
  /// Throws CampaignOwned when another process holds it, BadInput when the name stands for something else
  /// than a file, std::runtime_error when the folder cannot be written.
  explicit CampaignLock(const std::filesystem::path& folder);

  /// What was asked for is refused and nothing has been done: the file goes, if this lock has made it.
  void leave_no_trace();

 private:
  std::filesystem::path path_;
  FileDescriptor file_;
  bool made_ = false;  ///< it was not there before
};

/// "softwall on HOST, process N, started ..." while a runner works on the campaign in folder. The lock is
/// asked, not the list of processes: a runner on another host, or in another container, is in no list that is
/// seen from here. Changes nothing; asking takes a shared lock for a moment, which CampaignLock waits for.
[[nodiscard]] std::optional<std::string> living_owner(const std::filesystem::path& folder);

/// The lock belongs to another user, whom alone it tells who works on the campaign.
[[nodiscard]] bool owner_is_unknown(const std::filesystem::path& folder);

}  // namespace softwall::campaign
