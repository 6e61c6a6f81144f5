#include "solver/output/profile_table.hpp"

#include <algorithm>
#include <cstdio>

#include "solver/parallel/reduce.hpp"

namespace softwall::output {

std::array<parallel::PhaseRecord, parallel::kPhases> gather_profile(parallel::Profile& profile,
                                                                    const parallel::Communicator& world) {
  auto records = profile.read();
  for (parallel::PhaseRecord& r : records) {
    std::array<double, 4> sums{r.seconds, r.processor_seconds, double(r.messages), double(r.bytes)};
    parallel::sum(world, sums);
    r = {sums[0] / world.size(), sums[1] / world.size(), static_cast<std::int64_t>(sums[2]),
         static_cast<std::int64_t>(sums[3])};
  }
  return records;
}

std::string profile_table(const std::array<parallel::PhaseRecord, parallel::kPhases>& records,
                          std::int64_t steps, double cells, int ranks) {
  double total = 0;
  for (const auto& r : records) total += r.seconds;
  const double per_cell = 1e9 / (static_cast<double>(std::max<std::int64_t>(steps, 1)) * cells);
  const double per_rank = 1.0 / (static_cast<double>(std::max<std::int64_t>(steps, 1)) * ranks);
  std::string table = "phase           ns/cell/step   share   messages/step/rank   MB/step/rank\n";
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto& r = records[i];
    std::array<char, 120> line{};
    std::snprintf(line.data(), line.size(), "%-15s %12.2f %6.1f%% %20.1f %14.3f\n", parallel::kPhaseNames[i],
                  per_cell * r.seconds, total > 0 ? 100 * r.seconds / total : 0.0,
                  per_rank * static_cast<double>(r.messages), 1e-6 * per_rank * static_cast<double>(r.bytes));
    table += line.data();
  }
  return table;
}

}  // namespace softwall::output
