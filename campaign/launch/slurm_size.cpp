#include "campaign/launch/slurm_size.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <vector>

#include "campaign/core/words.hpp"
#include "campaign/launch/slurm_command.hpp"

namespace softwall::campaign {
namespace {

std::optional<long> count_in(std::string_view text) {
  long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The text before the next '|', which is taken away with it.
std::optional<std::string_view> next_field(std::string_view& line) {
  const auto end = line.find('|');
  if (end == std::string_view::npos) return std::nullopt;
  const auto field = line.substr(0, end);
  line.remove_prefix(end + 1);
  return field;
}

/// Adds the nodes of one line, all of them alike, to their partition's.
bool add_line(std::string_view line, std::map<std::string, ClusterSize, std::less<>>& partitions) {
  const auto partition = next_field(line), nodes = next_field(line), cores = next_field(line);
  if (!partition || partition->empty() || !nodes || !cores || !line.empty()) return false;
  const auto number = count_in(*nodes), each = count_in(*cores);
  if (!number || !each) return false;
  ClusterSize& size = partitions[std::string(*partition)];
  size.nodes += *number;
  size.cores += *number * *each;
  size.cores_of_a_node = std::max(size.cores_of_a_node, *each);
  return true;
}

}  // namespace

std::optional<ClusterSize> parse_sinfo(std::string_view text) {
  std::map<std::string, ClusterSize, std::less<>> partitions;
  while (!text.empty()) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos || !add_line(text.substr(0, end), partitions)) return std::nullopt;
    text.remove_prefix(end + 1);
  }
  if (partitions.empty()) return std::nullopt;
  ClusterSize largest;
  for (const auto& [name, size] : partitions) {
    largest.nodes = std::max(largest.nodes, size.nodes);
    largest.cores = std::max(largest.cores, size.cores);
    largest.cores_of_a_node = std::max(largest.cores_of_a_node, size.cores_of_a_node);
  }
  return largest;
}

std::optional<ClusterSize> cluster_size(const SlurmOptions& slurm, double seconds) {
  std::vector<std::string> arguments = {"--noheader", "--exact", "--Format=Partition:|,Nodes:|,CPUs:|"};
  if (!slurm.partition.empty()) arguments.push_back("--partition=" + slurm.partition);
  const Answer answer = ask_slurm("sinfo", arguments, seconds);
  return answer.exit_code == 0 ? parse_sinfo(answer.output) : std::nullopt;
}

std::string why_too_large(int ranks, const SlurmOptions& slurm, const ClusterSize& size) {
  if (slurm.nodes.value_or(1) > size.nodes)
    return "its partitions have at most " + counted(size.nodes, "node");
  if (slurm.nodes == 1 && ranks > size.cores_of_a_node)
    return "its nodes have at most " + counted(size.cores_of_a_node, "core");
  return ranks > size.cores ? "its partitions have at most " + counted(size.cores, "core") : "";
}

}  // namespace softwall::campaign
