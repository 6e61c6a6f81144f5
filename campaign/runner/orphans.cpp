#include "campaign/runner/orphans.hpp"

#include <algorithm>
#include <stdexcept>

#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_directory.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/system/clock.hpp"

namespace softwall::campaign {
namespace {

constexpr double kUnreachableSeconds =
    30.0;  // a solver that ends holds its lock a little longer than its name

struct Orphan {
  WorkPlace place;
  Handle handle;
  StopLadder ladder;
  double seen_at;       ///< monotonic seconds when the launcher last saw it
  bool reached = true;  ///< the launcher sees it, so that it hears of requests
};

/// Once nobody works there.
void tidy(const RunFiles& run, Launcher& launcher) {
  launcher.clean_up(run.directory);
  sweep_temporaries(run);
}

std::vector<RunFiles> runs_in(const std::vector<WorkPlace>& places) {
  std::vector<RunFiles> runs;
  for (const WorkPlace& place : places) runs.push_back(place.run);
  return runs;
}

Orphan orphan_in(const WorkPlace& place, StopGrace grace) {
  const auto record = read_run_record(place.run);
  const double now = monotonic_seconds();
  return {place, record ? record->handle : Handle(), StopLadder(grace, now), now};
}

void ask_to_end(Orphan& orphan, Launcher& launcher, StopLevel at_least) {
  const double now = monotonic_seconds();
  const auto& directory = orphan.place.run.directory;
  const Presence presence = launcher.presence(directory, orphan.handle);
  orphan.reached = presence == Presence::kRunning || presence == Presence::kQueued;
  if (orphan.reached) {
    orphan.seen_at = now;
    if (const auto level = orphan.ladder.due(now, at_least)) launcher.stop(directory, orphan.handle, *level);
  } else if (now - orphan.seen_at > kUnreachableSeconds) {
    throw std::runtime_error(
        "a solver that cannot be seen from here (of another user or another host) works in " +
        directory.string() + "; end it, then run the same command again");
  }
}

}  // namespace

bool end_orphans(const std::vector<WorkPlace>& places, Launcher& launcher, StopGrace grace, Signals& signals,
                 Progress& progress) {
  std::vector<Orphan> orphans;
  const auto busy = occupied(runs_in(places), launcher);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const WorkPlace& place = places[i];
    if (!std::filesystem::exists(place.run.directory)) continue;
    if (!busy[i]) {
      tidy(place.run, launcher);
      continue;
    }
    orphans.push_back(orphan_in(place, grace));
    progress.event(place.label +
                   ": a solver of an earlier softwall still works on it; waiting for its checkpoint");
  }
  while (!orphans.empty()) {
    const StopLevel at_least = level_of_requests(signals.stop_requests());
    for (Orphan& orphan : orphans) ask_to_end(orphan, launcher, at_least);
    signals.wait(std::chrono::milliseconds(100));
    const bool any_reached = std::ranges::any_of(orphans, &Orphan::reached);
    if (signals.stop_requests() > 0 && (!any_reached || launcher.attempts_stay())) return false;
    std::erase_if(orphans, [&](const Orphan& orphan) {
      if (is_occupied(orphan.place.run, launcher)) return false;  // few of them are left
      tidy(orphan.place.run, launcher);
      return true;
    });
  }
  return signals.stop_requests() == 0;
}

}  // namespace softwall::campaign
