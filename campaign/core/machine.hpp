#pragma once

#include <map>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "solver/case/bad_input.hpp"

/// What a campaign needs of the machine it is to run on. Pure: the machine is described by its caller.
namespace softwall::campaign {

struct Machine {
  int cores = 1;                                        ///< that this process may use
  double memory_bytes = 0.0;                            ///< 0: not known
  std::map<std::string, std::string> missing_programs;  ///< precision and the file that should be its solver
};

/// Memory of one case on so many ranks [B].
[[nodiscard]] double memory_bytes(const Case& c, int ranks);

/// Why this case could not be started on this machine, however often that was tried; empty: it can.
[[nodiscard]] std::vector<Mistake> obstacles(const CampaignCase& one, const Execution& execution,
                                             const Machine& machine);

/// "1.25 GB"
[[nodiscard]] std::string gigabytes(double bytes);

}  // namespace softwall::campaign
