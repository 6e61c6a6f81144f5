#include "campaign/runner/progress_line.hpp"

#include "campaign/core/eta.hpp"
#include "campaign/runner/wording.hpp"

namespace softwall::campaign {
namespace {

constexpr double kDrawSeconds = 1.0;      // between two lines on a terminal
constexpr double kTellSeconds = 300.0;    // and where there is none
constexpr double kEstimateSeconds = 5.0;  // between two estimates of the time that is left

std::map<std::string, Status> reports_of(const std::map<std::string, AttemptWatch>& working) {
  std::map<std::string, Status> reports;
  for (const auto& [id, watch] : working) {
    if (watch.status) reports[id] = *watch.status;
  }
  return reports;
}

bool has_passed(const std::optional<double>& since, double seconds, double now) {
  return !since || now - *since >= seconds;
}

}  // namespace

/// Where there is no terminal, nothing has to be told at the very beginning.
bool ProgressLine::is_due(double now) {
  if (!progress_.on_terminal() && !shown_at_) shown_at_ = now;
  if (!has_passed(shown_at_, progress_.on_terminal() ? kDrawSeconds : kTellSeconds, now)) return false;
  shown_at_ = now;
  return true;
}

void ProgressLine::show(const CaseBook& book, const std::map<std::string, AttemptWatch>& working,
                        double now) {
  if (!is_due(now)) return;
  const Campaign& campaign = book.campaign();
  const auto reports = reports_of(working);
  if (has_passed(estimated_at_, kEstimateSeconds, now)) {
    seconds_left_ = remaining_seconds(campaign, book.observations(), reports, campaign.execution.cores);
    estimated_at_ = now;
  }
  const std::string line = describe_progress(campaign, book.observations(), reports, seconds_left_);
  progress_.on_terminal() ? progress_.draw(line) : progress_.event(line);
}

}  // namespace softwall::campaign
