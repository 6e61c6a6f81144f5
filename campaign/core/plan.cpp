#include "campaign/core/plan.hpp"

#include <string_view>
#include <unordered_map>

#include "campaign/core/words.hpp"
#include "solver/case/time_comparison.hpp"

namespace softwall::campaign {
namespace {

class Planner {
 public:
  Planner(const Campaign& campaign, const std::vector<Observation>& observations) : campaign_(campaign) {
    for (const auto& observation : observations) observations_[observation.case_id] = &observation;
    for (const auto& c : campaign.cases) cases_[c.definition.id] = &c;
  }

  [[nodiscard]] std::filesystem::path initial_checkpoint(const CampaignCase& c) const {
    if (c.precursor_id.empty()) return {};
    return observation(c.precursor_id).newest_checkpoint.value_or(std::filesystem::path());
  }

  /// Of the case that it starts from first, so that nobody's is decided twice.
  [[nodiscard]] const Decision& decide(const CampaignCase& c) {
    const auto known = decisions_.find(c.definition.id);
    if (known != decisions_.end()) return known->second;
    Decision made = decide_anew(c);
    return decisions_.emplace(c.definition.id, std::move(made)).first->second;
  }

 private:
  [[nodiscard]] Decision decide_anew(const CampaignCase& c) {
    const Observation& seen = observation(c.definition.id);
    if (seen.running || seen.state == CaseState::kRunning)
      return made(c, Outlook::kRunning, why_running(seen.presence));
    if (is_finished(c)) return made(c, Outlook::kKept, seen.early ? seen.reason : "finished");
    if (const std::string why = why_blocked(c, seen); !why.empty()) return made(c, Outlook::kBlocked, why);
    if (seen.newest_checkpoint)
      return made(c, Outlook::kResume, "from step " + std::to_string(seen.step) + after(seen));
    if (!c.precursor_id.empty()) return decide_by_start(c, seen);
    return made(c, Outlook::kStart, start_reason(seen));
  }

  static std::string why_running(Presence presence) {
    if (presence == Presence::kQueued) return "its job waits in the queue";
    if (presence == Presence::kUnknown) return "its job may be at work, nobody can say at the moment";
    return "a solver is at work on it";
  }

  static Decision made(const CampaignCase& c, Outlook outlook, std::string reason) {
    return {c.definition.id, outlook, std::move(reason)};
  }

  static std::string after(const Observation& seen) {
    return seen.reason.empty() ? "" : ", after: " + seen.reason;
  }

  static std::string start_reason(const Observation& seen) {
    return seen.attempts == 0 ? "new" : "again from the start, no checkpoint yet" + after(seen);
  }

  /// Everybody knows what a precursor is there for; of a line of cases it is told.
  static std::string start_reason(const CampaignCase& first, const Observation& seen) {
    return start_reason(seen) + (first.is_precursor ? "" : ", from the end of " + first.definition.label);
  }

  [[nodiscard]] const Observation& observation(const std::string& case_id) const {
    static const Observation kNothing;
    const auto found = observations_.find(case_id);
    return found == observations_.end() ? kNothing : *found->second;
  }

  /// A finished case whose end time has since been extended is not finished, unless its intervals are small
  /// enough.
  [[nodiscard]] bool is_finished(const CampaignCase& c) const {
    const Observation& seen = observation(c.definition.id);
    return seen.state == CaseState::kFinished &&
           (seen.early || has_reached(seen.time, c.definition.run.end_time));
  }

  /// Why a person must look at this case; empty when it may run.
  [[nodiscard]] std::string why_blocked(const CampaignCase& c, const Observation& seen) const {
    const Execution& execution = campaign_.execution;
    if (seen.state == CaseState::kDiverged)
      return "diverged" + after(seen) +
             "; it would do so again unchanged (another version of the solver "
             "may not: remove its checkpoints, then resume --start-over)";
    if (!seen.needs_person.empty()) return seen.needs_person;
    if (!seen.retry_allowed) return "cannot succeed unchanged" + after(seen);
    if (seen.attempts_without_progress >= execution.max_failures_without_progress)
      return std::to_string(seen.attempts_without_progress) + " attempts without progress" + after(seen);
    if (execution.cores > 0 && c.ranks > execution.cores)
      return "needs " + std::to_string(c.ranks) + " cores, there are " + std::to_string(execution.cores);
    return "";
  }

  /// Of a case that starts from another. The campaign has that one before it, so that there is no circle.
  [[nodiscard]] Decision decide_by_start(const CampaignCase& c, const Observation& seen) {
    const auto found = cases_.find(c.precursor_id);
    if (found == cases_.end())
      return made(c, Outlook::kBlocked,
                  "the case that it starts from, " + c.precursor_id + ", is not in the campaign");
    const CampaignCase& first = *found->second;
    const std::string& name = first.definition.label;
    if (is_finished(first)) {
      const Observation& start = observation(c.precursor_id);
      const double end_time = first.definition.run.end_time;
      if (!has_ended_at(start.time, start.step, end_time))
        return made(c, Outlook::kBlocked, why_beyond(name, start.time, end_time));
      if (start.newest_checkpoint) return made(c, Outlook::kStart, start_reason(first, seen));
      if (!start.needs_person.empty()) return blocked_by(c, first, start.needs_person);
      return made(c, Outlook::kBlocked, name + " has finished, but none of its checkpoints is valid");
    }
    const Decision& before = decide(first);
    if (before.outlook == Outlook::kBlocked) return blocked_by(c, first, before.reason);
    return made(c, Outlook::kWaiting, "for " + name);
  }

  /// A case says from which time of another it starts, so that it cannot start from a later one.
  static std::string why_beyond(const std::string& name, double time, double end_time) {
    return name + " is at t = " + short_number(time) + ", beyond the end time of " + short_number(end_time) +
           " that this case starts from; raise that end time again, or give the campaign a new folder";
  }

  /// What the first case that cannot go on needs, however many wait in a line behind it.
  [[nodiscard]] Decision blocked_by(const CampaignCase& c, const CampaignCase& first,
                                    const std::string& reason) {
    const auto passed_on = blocked_by_others_.find(first.definition.id);
    const std::string why = passed_on == blocked_by_others_.end()
                                ? "needs " + first.definition.label + ": " + reason
                                : passed_on->second;
    blocked_by_others_.emplace(c.definition.id, why);
    return made(c, Outlook::kBlocked, why);
  }

  const Campaign& campaign_;
  std::unordered_map<std::string_view, const Observation*> observations_;
  std::unordered_map<std::string_view, const CampaignCase*> cases_;
  std::unordered_map<std::string_view, Decision> decisions_;             ///< those made
  std::unordered_map<std::string_view, std::string> blocked_by_others_;  ///< and why, for people
};

}  // namespace

std::vector<Decision> decide(const Campaign& campaign, const std::vector<Observation>& observations) {
  Planner planner(campaign, observations);
  std::vector<Decision> decisions;
  for (const auto& c : campaign.cases) decisions.push_back(planner.decide(c));
  return decisions;
}

std::vector<Action> plan(const Campaign& campaign, const std::vector<Observation>& observations,
                         int cores_free) {
  Planner planner(campaign, observations);
  std::vector<Action> actions;
  for (const auto& c : campaign.cases) {
    const Outlook outlook = planner.decide(c).outlook;
    if ((outlook != Outlook::kStart && outlook != Outlook::kResume) || c.ranks > cores_free) continue;
    cores_free -= c.ranks;
    actions.push_back({c.definition.id, c.ranks, planner.initial_checkpoint(c)});
  }
  return actions;
}

std::string to_string(Outlook outlook) {
  switch (outlook) {
    case Outlook::kStart:
      return "start";
    case Outlook::kResume:
      return "resume";
    case Outlook::kRunning:
      return "running";
    case Outlook::kKept:
      return "kept";
    case Outlook::kWaiting:
      return "waiting";
    case Outlook::kBlocked:
      return "blocked";
  }
  return "?";
}

}  // namespace softwall::campaign
