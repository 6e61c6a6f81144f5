#pragma once

#include <vector>

#include "campaign/tables/comparison.hpp"

namespace softwall::campaign {

/// How far what was measured is from rows of the paper.
struct Departure {
  double rms = 0;  ///< of (measured - printed) / (range of the column over the paper's cases)
  int values = 0, rows = 0;
};

struct ReadingFit {
  const Reading* reading;
  Departure all;     ///< from every row that has a result under this reading
  Departure shared;  ///< from those that have one under each of the readings: only these compare them
};

/// One for each of kReadings, over Re_tau of both walls, the maximum of the mean velocity and its place, and
/// the deformation of elastic walls. The log law is left out: its intervals are wide. Of a case on several
/// grids the finest counts.
[[nodiscard]] std::vector<ReadingFit> reading_fits(const std::vector<MeasuredCase>& cases);

/// The one with the least departure from the shared rows; null when there are none.
[[nodiscard]] const ReadingFit* best_of(const std::vector<ReadingFit>& fits);

}  // namespace softwall::campaign
