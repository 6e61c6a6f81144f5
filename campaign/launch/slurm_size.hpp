#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "campaign/core/campaign.hpp"

/// How large the cluster is, whether or not all of it is up.
namespace softwall::campaign {

/// The largest partition's nodes and cores, and the cores of the largest node.
struct ClusterSize {
  long nodes = 0, cores = 0, cores_of_a_node = 0;
};

/// Lines of `sinfo --exact --Format=Partition:|,Nodes:|,CPUs:|`. Empty when anything in them is not of that
/// form, or there is none.
[[nodiscard]] std::optional<ClusterSize> parse_sinfo(std::string_view text);

/// Of the partitions of these options; empty where Slurm does not say.
[[nodiscard]] std::optional<ClusterSize> cluster_size(const SlurmOptions& slurm, double seconds);

/// Why a job of one case can never run there, also when every node is up: sbatch has the same words for a
/// node that is down just now. Empty: it may run.
[[nodiscard]] std::string why_too_large(int ranks, const SlurmOptions& slurm, const ClusterSize& size);

}  // namespace softwall::campaign
