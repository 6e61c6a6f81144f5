#include "campaign/observe/averages.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "solver/run_directory/statistics_file.hpp"

namespace softwall::campaign {

analysis::DeriveOptions window_from(double start) {
  analysis::DeriveOptions options;
  if (start > 0) options.window_start = start;
  return options;
}

std::optional<analysis::DerivedQuantities> averages_so_far(const CampaignCase& one, const RunFiles& run) {
  if (!std::filesystem::exists(run.statistics())) return std::nullopt;
  try {
    const auto statistics = analysis::read_statistics(run.statistics());
    if (statistics.case_id != one.definition.id) return std::nullopt;
    return analysis::derive(statistics, window_from(one.window_start));
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

bool intervals_are_met(const CampaignCase& one, const RunFiles& run) {
  if (one.until.empty()) return false;
  const auto averages = averages_so_far(one, run);
  return averages && are_met(one.until, [&](const std::string& quantity) {
           const auto member =
               std::ranges::find(analysis::kMeasuredMembers, quantity, &analysis::MeasuredMember::name);
           const analysis::Measured& found = (*averages).*member->member;
           return UncertainResult{found.value, found.ci95};
         });
}

}  // namespace softwall::campaign
