#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "solver/run_directory/status.hpp"

namespace softwall::campaign {

/// Wall-clock seconds until all unfinished cases are done on this many cores: measured speed where a case has
/// run, that of its like where one of them has, a default before that. Blocked cases cost nothing.
[[nodiscard]] double remaining_seconds(const Campaign& campaign, const std::vector<Observation>& observations,
                                       const std::map<std::string, Status>& working, int cores);

/// Wall-clock seconds that a case takes to its end time, from its newest checkpoint on: as many steps as its
/// mean step so far makes, each of as many core-seconds as those of its last attempt. Empty before it has
/// made any.
[[nodiscard]] std::optional<double> measured_seconds_left(const CampaignCase& one, const Observation& seen);

/// What was measured in a campaign.
class MeasuredSpeed {
 public:
  MeasuredSpeed(const Campaign& campaign, const std::vector<Observation>& observations);

  /// Core-nanoseconds per cell and step, the mean over cases of the same flow, precision and formulation; the
  /// default of estimate.hpp when nothing was measured of them.
  [[nodiscard]] double ns_per_cell_step(const Physics& physics) const;

 private:
  struct Sum {
    double ns = 0;
    int cases = 0;
  };
  using Kind = std::tuple<FlowType, Precision, std::optional<SolidFormulation>>;
  static Kind kind_of(const Physics& physics);

  std::map<Kind, Sum> sums_;
};

}  // namespace softwall::campaign
