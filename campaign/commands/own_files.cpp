#include "campaign/commands/own_files.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "campaign/commands/campaign_folder.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kOwn = {"results.db",    "results.db-wal", "results.db-shm",
                                                  "campaign.json", "campaign.lock",  "manager.log"};

}  // namespace

void refuse_own_files(const std::string& command, const fs::path& file, const fs::path& campaign) {
  const fs::path target = fs::weakly_canonical(file);
  const fs::path inside = target.lexically_relative(fs::weakly_canonical(folder_with_store(campaign)));
  const bool own = std::ranges::find(kOwn, inside.string()) != kOwn.end() || *inside.begin() == "cases" ||
                   target == fs::weakly_canonical(campaign);
  if (own) throw BadInput(command, {{"", file.string() + " belongs to the campaign itself", "another file"}});
}

}  // namespace softwall::campaign
