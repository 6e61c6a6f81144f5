#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/observe/ladder.hpp"
#include "campaign/runner/progress.hpp"
#include "campaign/store/store.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {

/// What the runner knows about each case: its directory, what was last observed there, and why it is not to
/// be run again before a user has looked.
class CaseBook {
 public:
  CaseBook(Campaign campaign, std::filesystem::path folder, Store& store, Progress& progress);
  /// From now on cases may start from the beginning although they had checkpoints.
  void allow_starting_over() { may_start_over_ = true; }
  [[nodiscard]] bool may_start_over() const { return may_start_over_; }

  [[nodiscard]] const Campaign& campaign() const { return campaign_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// In the order of campaign().cases.
  [[nodiscard]] const std::vector<Observation>& observations() const { return observations_; }

  [[nodiscard]] const CampaignCase& find(const std::string& case_id) const;
  [[nodiscard]] RunFiles files_of(const CampaignCase& one) const;
  [[nodiscard]] const Observation& seen(const CampaignCase& one) const;

  /// Observe the files of a case again. Whether a solver works on it is not asked: the runner knows which
  /// cases it has started or adopted, and has ended all others before.
  void look_at(const CampaignCase& one);
  void look_at(const CampaignCase& one, const Observation& files, const CaseRecord& known);
  /// What it has left is taken from the store (store/settled.hpp).
  void settle(const CampaignCase& one, const CaseRecord& known);
  [[nodiscard]] bool is_settled(const CampaignCase& one) const;
  void mark_running(const CampaignCase& one, Presence presence = Presence::kRunning);
  /// It has diverged, and may be tried again: once, because what diverges again does so for ever.
  void forgive_divergence(const CampaignCase& one);
  /// It has finished, but goes on from its last checkpoint, because something that it left is missing.
  void mark_unfinished(const CampaignCase& one, const std::filesystem::path& last_checkpoint,
                       const std::string& reason);
  /// A finished case from which others have yet to start is of use to them only with its last checkpoint: if
  /// that is damaged, it is to go on from an older one, which gives the same last checkpoint again. If it
  /// cannot be read at present, they wait.
  void look_at_starting_points();
  void look_at_starting_point(const CampaignCase& one);

  /// Neither is started again in this run. A case that is given up would fail again unchanged; a paused one
  /// waits until somebody has put right what is in its way.
  void give_up(const CampaignCase& one, const std::string& reason);
  void pause(const CampaignCase& one, const std::string& reason);
  /// All that is not finished, observed again without the store, which is in trouble.
  void pause_unfinished(const std::string& reason);
  [[nodiscard]] const std::map<std::string, std::string>& given_up() const { return given_up_; }
  [[nodiscard]] const std::map<std::string, std::string>& paused() const { return paused_; }

  /// Check the ladder of a case that nobody works on; what is set aside is told and recorded.
  Ladder check(const CampaignCase& one);

 private:
  [[nodiscard]] std::size_t index_of(const std::string& case_id) const;
  [[nodiscard]] bool is_needed(const CampaignCase& start) const;

  Campaign campaign_;
  std::filesystem::path folder_;
  Store& store_;
  Progress& progress_;
  std::vector<Observation> observations_;
  std::unordered_map<std::string, std::size_t> index_;  ///< by case id
  std::unordered_map<std::string, std::vector<std::size_t>>
      started_by_;             ///< by the id of the case that they start from
  std::vector<bool> settled_;  ///< in the order of campaign().cases
  bool may_start_over_ = false;
  std::map<std::string, std::string> given_up_, paused_;  ///< case id -> reason
};

}  // namespace softwall::campaign
