#pragma once

#include <optional>
#include <vector>

#include "campaign/launch/launcher.hpp"
#include "campaign/launch/slurm_queue.hpp"

/// What the jobs that Slurm tells of mean for an attempt.
namespace softwall::campaign {

/// The one of several jobs of a name that is furthest from its end; null where there is none.
[[nodiscard]] const QueuedJob* most_alive(const std::vector<QueuedJob>& jobs);

/// What Slurm says about the end of a job; empty where the exit status tells more.
[[nodiscard]] std::optional<Verdict> verdict_on(const QueuedJob& job);

}  // namespace softwall::campaign
