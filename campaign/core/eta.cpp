#include "campaign/core/eta.hpp"

#include <algorithm>
#include <unordered_map>

#include "campaign/core/estimate.hpp"
#include "campaign/core/plan.hpp"

namespace softwall::campaign {
namespace {

double cells_of(const CampaignCase& one) {
  const GridSpec& grid = one.definition.physics.grid;
  return static_cast<double>(grid.nx) * grid.ny() * grid.nz;
}

/// The remaining time by the report of the working solver; 0 when it does not say.
double wall_seconds_left(const Status& status, double end_time) {
  if (status.dt <= 0 || status.seconds_per_step <= 0) return 0;
  return std::max(0.0, end_time - status.time) / status.dt * status.seconds_per_step;
}

/// Of a case that is done, or that will not run unless somebody does something about it.
bool costs_nothing(const Decision& decision) {
  return decision.outlook == Outlook::kKept || decision.outlook == Outlook::kBlocked;
}

}  // namespace

MeasuredSpeed::MeasuredSpeed(const Campaign& campaign, const std::vector<Observation>& observations) {
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const CampaignCase& one = campaign.cases[i];
    if (observations[i].seconds_per_step <= 0) continue;
    Sum& sum = sums_[{one.definition.physics.flow, one.definition.physics.precision}];
    sum.ns += observations[i].seconds_per_step * one.ranks * 1e9 / cells_of(one);
    ++sum.cases;
  }
}

double MeasuredSpeed::ns_per_cell_step(const Physics& physics) const {
  const auto found = sums_.find({physics.flow, physics.precision});
  return found == sums_.end() ? default_ns_per_cell_step(physics) : found->second.ns / found->second.cases;
}

std::optional<double> measured_seconds_left(const Observation& seen) {
  if (seen.step <= 0 || seen.time <= 0 || seen.seconds_per_step <= 0) return std::nullopt;
  const double steps = (seen.end_time - seen.time) / (seen.time / static_cast<double>(seen.step));
  return std::max(0.0, steps) * seen.seconds_per_step;
}

double remaining_seconds(const Campaign& campaign, const std::vector<Observation>& observations,
                         const std::map<std::string, Status>& working, int cores) {
  const MeasuredSpeed speed(campaign, observations);
  const std::vector<Decision> decisions = decide(campaign, observations);
  double before = 0;   // precursors: everything else waits for them
  double longest = 0;  // no case can be split, nor begin before the one that it starts from has ended
  std::unordered_map<std::string, double> ends;  // of those that are no precursors, by case id
  double core_seconds = 0;
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const CampaignCase& one = campaign.cases[i];
    if (costs_nothing(decisions[i])) continue;
    const auto status = working.find(one.definition.id);
    double seconds =
        status == working.end() ? 0 : wall_seconds_left(status->second, one.definition.run.end_time);
    if (seconds == 0) {
      const double ns = speed.ns_per_cell_step(one.definition.physics);
      const double reached = status == working.end() ? observations[i].time : status->second.time;
      seconds = estimate(one.definition, ns, reached).core_hours * 3600 / one.ranks;
    }
    if (one.is_precursor) {
      before = std::max(before, seconds);
    } else {
      const auto start = ends.find(one.precursor_id);
      const double end = seconds + (start == ends.end() ? 0 : start->second);
      ends.emplace(one.definition.id, end);
      longest = std::max(longest, end);
      core_seconds += seconds * one.ranks;
    }
  }
  return before + std::max(longest, core_seconds / std::max(1, cores));
}

}  // namespace softwall::campaign
