#pragma once

#include <memory>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/launch/launcher.hpp"

namespace softwall::campaign {

/// The launcher that execution.launcher of a campaign file names. Throws BadInput for an unknown name. Making
/// one asks and starts nothing.
[[nodiscard]] std::unique_ptr<Launcher> make_launcher(const Execution& execution);

/// Every name that make_launcher() knows; schemas/campaign.schema.json lists the same.
[[nodiscard]] std::vector<std::string> launcher_names();

}  // namespace softwall::campaign
