#include "campaign/store/import_directories.hpp"

#include <stdexcept>

#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/store/import_results.hpp"

namespace softwall::campaign {
namespace {

/// An attempt at work, or in a queue, has not ended. A solver that was started by hand is none.
void import_attempts(Store& store, const CampaignCase& one, const RunFiles& run, const Observation& seen) {
  const auto record = read_run_record(run);
  if (!seen.running || !record || record->case_id != one.definition.id)
    return import_history(store, one, run, seen);
  import_running_attempt(store, one, run, *record);
  import_checkpoints(store, one.definition.id, run);
}

/// True when it was derived now.
bool import_any_result(Store& store, const CampaignCase& one, const RunFiles& run, CaseState state) {
  return state == CaseState::kFinished ? import_result(store, one, run)
                                       : import_result_so_far(store, one, run, state);
}

}  // namespace

ImportedDirectories import_directories(Store& store, const std::vector<CampaignCase>& cases,
                                       const std::filesystem::path& folder, const Launcher& launcher) {
  std::vector<const CampaignCase*> all;
  for (const CampaignCase& one : cases) all.push_back(&one);
  const auto seen = observe_all(all, folder, launcher);
  ImportedDirectories imported;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const RunFiles run = run_files(folder, cases[i]);
    import_attempts(store, cases[i], run, seen[i]);
    try {
      imported.results += import_any_result(store, cases[i], run, seen[i].state) ? 1 : 0;
    } catch (const SqliteError&) {
      throw;
    } catch (const std::runtime_error& error) {
      imported.troubles.push_back(cases[i].definition.label + ": no result: " + error.what());
    }
  }
  return imported;
}

}  // namespace softwall::campaign
