#pragma once

#include <string>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/observe/history.hpp"
#include "campaign/store/store.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {

/// Holds the rows of a store against what campaign file and run directories say now, so that a bit that has
/// changed in results.db shows. SQLite finds damage to its own structure and to words that a column does not
/// allow, but not another number. What stands nowhere else cannot be held against anything: when a row was
/// made or changed, and checkpoints that are gone.
class StoreCheck {
 public:
  /// `store` must outlive this object.
  StoreCheck(Store& store, const LoadedCampaign& loaded);

  /// In what its views, or its page about itself, differ from those of this program; empty: in nothing.
  [[nodiscard]] std::string trouble_with_words();
  /// In what the rows of a case that nobody works on differ; empty: in nothing.
  [[nodiscard]] std::string trouble_with_case(const CampaignCase& one, const RunFiles& run);

 private:
  [[nodiscard]] std::string difference_in_case_row(const std::string& case_id);
  [[nodiscard]] std::string difference_in_documents(const std::string& case_id);
  [[nodiscard]] std::string difference_in_attempts(const std::string& case_id, const RunFiles& run) const;
  [[nodiscard]] std::string difference_in_checkpoints(const std::string& case_id, const RunFiles& run);
  [[nodiscard]] std::string difference_in_quantities(const std::string& case_id);
  [[nodiscard]] std::string difference_in_result(const CampaignCase& one, const RunFiles& run);

  Store& store_;
  Store expected_;             ///< in memory: as the campaign file and the run directories would make it
  bool same_campaign_ = true;  ///< false: the campaign file has been edited since it was last run
};

}  // namespace softwall::campaign
