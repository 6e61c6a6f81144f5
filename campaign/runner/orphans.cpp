#include "campaign/runner/orphans.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/launch/process_launcher.hpp"
#include "campaign/launch/scratch.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_directory.hpp"
#include "campaign/system/clock.hpp"
#include "campaign/system/process_identity.hpp"

namespace softwall::campaign {
namespace {

constexpr double kLockOnlySeconds = 30.0;  // a solver that ends holds its lock a little longer than its name

struct Orphan {
  std::string label;
  RunFiles run;
  StopLadder ladder;
  double seen_at;  ///< monotonic seconds when a process of it was last seen
};

/// Once nobody works there.
void tidy(const RunFiles& run) {
  Scratch(run.directory).remove();
  sweep_temporaries(run);
}

void ask_to_end(Orphan& orphan) {
  const double now = monotonic_seconds();
  if (!processes_of(orphan.run.directory).empty()) {
    orphan.seen_at = now;
    if (const auto level = orphan.ladder.due(now)) signal_attempt(orphan.run.directory, *level);
  } else if (now - orphan.seen_at > kLockOnlySeconds) {
    throw std::runtime_error(
        "a solver that cannot be seen from here (of another user or another host) works in " +
        orphan.run.directory.string() + "; end it, then run the same command again");
  }
}

}  // namespace

bool end_orphans(const Campaign& campaign, const std::filesystem::path& folder, StopGrace grace,
                 Signals& signals, Progress& progress) {
  std::vector<Orphan> orphans;
  for (const CampaignCase& one : campaign.cases) {
    const RunFiles run = run_files(folder, one);
    if (!std::filesystem::exists(run.directory)) continue;
    if (!is_occupied(run)) {
      tidy(run);
      continue;
    }
    const double now = monotonic_seconds();
    orphans.push_back({one.definition.label, run, StopLadder(grace, now), now});
    progress.event(one.definition.label +
                   ": a solver of an earlier softwall still works on it; waiting for its checkpoint");
  }
  while (!orphans.empty()) {
    for (Orphan& orphan : orphans) ask_to_end(orphan);
    signals.wait(std::chrono::milliseconds(100));
    if (signals.stop_requests() > 0) return false;
    std::erase_if(orphans, [](const Orphan& orphan) {
      if (is_occupied(orphan.run)) return false;
      tidy(orphan.run);
      return true;
    });
  }
  return true;
}

}  // namespace softwall::campaign
