#pragma once

#include <filesystem>

#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {

/// A store holds the campaign as it was last run. Tells, on standard error, where the campaign file that
/// `named` means (a file or its folder) is another one, or has been changed since.
void tell_if_not_as_last_run(const std::filesystem::path& named, Connection& store);

}  // namespace softwall::campaign
