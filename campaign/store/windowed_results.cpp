#include "campaign/store/windowed_results.hpp"

#include <stdexcept>

#include "solver/run_directory/build_info.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/run_directory/statistics_file.hpp"

namespace softwall::campaign {
namespace {

bool has_statistics(const RunFiles& run) {
  std::error_code unreadable;
  return std::filesystem::exists(run.statistics(), unreadable);
}

/// Whether the store has a result of it, but over another window.
bool has_another_result(const Store& store, const std::string& case_id, double start) {
  const auto origin = store.result_origin(case_id);
  return origin && origin->window_asked != start;
}

}  // namespace

WindowedResults results_from(const std::filesystem::path& campaign_directory, double start) {
  WindowedResults results{Store::copy_in_memory(campaign_directory), {}};
  analysis::DeriveOptions window;
  window.window_start = start;
  Transaction together(results.store.connection());
  for (const auto& [id, one] : results.store.all_cases()) {
    const RunFiles run{campaign_directory / one.directory};
    if (one.is_precursor || one.state == CaseState::kDiverged) continue;
    if (!has_statistics(run) && !has_another_result(results.store, id, start)) continue;
    try {
      const auto derived = analysis::derive(analysis::read_statistics(run.statistics()), window);
      results.store.record_result(id, derived, build_info().git_revision);
    } catch (const SqliteError&) {
      throw;
    } catch (const std::runtime_error& error) {
      results.store.remove_result(id);
      results.troubles.push_back(one.label + ": " + error.what());
    }
  }
  together.commit();
  return results;
}

}  // namespace softwall::campaign
