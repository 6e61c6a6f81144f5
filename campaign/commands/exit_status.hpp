#pragma once

namespace softwall::campaign {

/// What softwall says by its exit status.
enum class ExitStatus : int {
  kDone = 0,         ///< everything asked for is there
  kError = 1,        ///< softwall itself failed, or something around it
  kBadInput = 2,     ///< usage, a campaign file or a place that cannot be used
  kFailedCases = 3,  ///< done, but some cases failed or diverged
  kUnfinished = 4,   ///< stopped before the end: resume
  kOwned = 5         ///< another runner works on the campaign
};

}  // namespace softwall::campaign
