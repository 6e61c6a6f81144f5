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

/// On which the speed of a case was measured.
int measured_ranks(const CampaignCase& one, const Observation& seen) {
  return seen.measured_ranks > 0 ? seen.measured_ranks : one.ranks;
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

/// What is left of one case, and how many cores it takes.
struct Work {
  double seconds = 0;
  int ranks = 0;
};

/// Of a working solver by its own report, whatever ranks the campaign file asks for by now.
Work work_left(const CampaignCase& one, const Observation& seen, const Status* working,
               const MeasuredSpeed& speed) {
  const double told = working ? wall_seconds_left(*working, one.definition.run.end_time) : 0;
  if (told > 0) return {told, working->ranks > 0 ? working->ranks : one.ranks};
  const double reached = working ? working->time : seen.time;
  const double ns = speed.ns_per_cell_step(one.definition.physics);
  return {estimate(one.definition, ns, reached).core_hours * 3600 / one.ranks, one.ranks};
}

/// Cases that share the cores. None of them can be split, nor begin before the one that it starts from ends.
class SideBySide {
 public:
  void add(const CampaignCase& one, const Work& work) {
    const auto start = ends_.find(one.precursor_id);
    const double end = work.seconds + (start == ends_.end() ? 0 : start->second);
    ends_.emplace(one.definition.id, end);
    longest_ = std::max(longest_, end);
    core_seconds_ += work.seconds * work.ranks;
  }
  [[nodiscard]] double seconds_on(int cores) const {
    return std::max(longest_, core_seconds_ / std::max(1, cores));
  }

 private:
  std::unordered_map<std::string, double> ends_;  // by case id
  double longest_ = 0, core_seconds_ = 0;
};

}  // namespace

MeasuredSpeed::Kind MeasuredSpeed::kind_of(const Physics& physics) {
  const auto formulation = physics.solid ? std::optional(physics.solid->formulation) : std::nullopt;
  return {physics.flow, physics.precision, formulation};
}

MeasuredSpeed::MeasuredSpeed(const Campaign& campaign, const std::vector<Observation>& observations) {
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const CampaignCase& one = campaign.cases[i];
    if (observations[i].seconds_per_step <= 0) continue;
    Sum& sum = sums_[kind_of(one.definition.physics)];
    sum.ns += observations[i].seconds_per_step * measured_ranks(one, observations[i]) * 1e9 / cells_of(one);
    ++sum.cases;
  }
}

double MeasuredSpeed::ns_per_cell_step(const Physics& physics) const {
  const auto found = sums_.find(kind_of(physics));
  return found == sums_.end() ? default_ns_per_cell_step(physics) : found->second.ns / found->second.cases;
}

std::optional<double> measured_seconds_left(const CampaignCase& one, const Observation& seen) {
  if (seen.step <= 0 || seen.time <= 0 || seen.seconds_per_step <= 0) return std::nullopt;
  const double steps = (seen.end_time - seen.time) / (seen.time / static_cast<double>(seen.step));
  return std::max(0.0, steps) * seen.seconds_per_step * measured_ranks(one, seen) / one.ranks;
}

double remaining_seconds(const Campaign& campaign, const std::vector<Observation>& observations,
                         const std::map<std::string, Status>& working, int cores) {
  const MeasuredSpeed speed(campaign, observations);
  const std::vector<Decision> decisions = decide(campaign, observations);
  SideBySide precursors, others;  // all others wait for the precursors
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const CampaignCase& one = campaign.cases[i];
    if (costs_nothing(decisions[i])) continue;
    const auto status = working.find(one.definition.id);
    const Status* const told = status == working.end() ? nullptr : &status->second;
    (one.is_precursor ? precursors : others).add(one, work_left(one, observations[i], told, speed));
  }
  return precursors.seconds_on(cores) + others.seconds_on(cores);
}

}  // namespace softwall::campaign
