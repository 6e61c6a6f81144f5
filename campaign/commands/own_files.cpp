#include "campaign/commands/own_files.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "campaign/commands/campaign_folder.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> kOwn = {"results.db",         "results.db-wal", "results.db-shm",
                                                  "results.db-journal", "campaign.json",  "campaign.lock",
                                                  "manager.log"};

}  // namespace

void refuse_own_files(const std::string& command, const fs::path& file, const fs::path& campaign) {
  const auto real = [](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); };
  const fs::path target = real(file);
  const fs::path inside = target.lexically_relative(real(folder_with_store(campaign)));
  const bool is_of_a_case = !inside.empty() && *inside.begin() == "cases";
  const bool own =
      std::ranges::find(kOwn, inside.string()) != kOwn.end() || is_of_a_case || target == real(campaign);
  if (own) throw BadInput(command, {{"", file.string() + " belongs to the campaign itself", "another file"}});
}

}  // namespace softwall::campaign
