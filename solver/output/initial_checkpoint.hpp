#pragma once

#include <filesystem>

#include "solver/case/case.hpp"
#include "solver/run_directory/checkpoint_header.hpp"

namespace softwall::output {

/// Throws unless the file is an intact checkpoint of the case that `initial` names, at its end or later. On
/// one rank. AgreedError: 78 when it is missing, of another case or too early, 77 when it is damaged.
[[nodiscard]] CheckpointHeader check_initial_checkpoint(const std::filesystem::path& file,
                                                        const InitialSpec& initial);

}  // namespace softwall::output
