#pragma once

#include <map>
#include <optional>
#include <string>

#include "campaign/runner/attempt_watch.hpp"
#include "campaign/runner/case_book.hpp"
#include "campaign/runner/progress.hpp"

namespace softwall::campaign {

/// How far a campaign is, in one line: drawn again and again on a terminal, told now and then where there is
/// none. Of ten thousand cases neither the line nor the time that is left is made more often than a person
/// looks.
class ProgressLine {
 public:
  explicit ProgressLine(Progress& progress) : progress_(progress) {}

  /// Shows the line if it is time to. now: monotonic seconds.
  void show(const CaseBook& book, const std::map<std::string, AttemptWatch>& working, double now);

 private:
  [[nodiscard]] bool is_due(double now);

  Progress& progress_;
  std::optional<double> shown_at_;
  std::optional<double> estimated_at_;
  double seconds_left_ = 0.0;
};

}  // namespace softwall::campaign
