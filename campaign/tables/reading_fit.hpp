#pragma once

#include <vector>

#include "campaign/tables/comparison.hpp"

namespace softwall::campaign {

/// How far what was measured is from the paper under a reading of its G.
struct ReadingFit {
  const Reading* reading;
  double departure = 0;  ///< rms of (measured - printed) / (range of the column over the paper's cases)
  int values = 0, cases = 0;
};

/// One for each of kReadings, over Re_tau of both walls, the maximum of the mean velocity and its place, and
/// the deformation of elastic walls. The log law is left out: its intervals are wide. Of a
/// case on several grids the finest counts.
[[nodiscard]] std::vector<ReadingFit> reading_fits(const std::vector<MeasuredCase>& cases);

/// The one with the least departure; null when none has any value.
[[nodiscard]] const ReadingFit* best_of(const std::vector<ReadingFit>& fits);

}  // namespace softwall::campaign
