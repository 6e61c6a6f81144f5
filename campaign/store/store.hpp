#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/derived.hpp"
#include "campaign/core/attempt.hpp"
#include "campaign/core/campaign.hpp"
#include "campaign/core/checkpoint_record.hpp"
#include "campaign/store/sqlite.hpp"
#include "campaign/store/store_file.hpp"

/// The results store, <campaign directory>/results.db: what was asked for, what was tried, what came out.
/// Tables and columns: schemas/results.sql. The run directories are the truth; the store can be made again
/// from them. Only the manager writes it. Every write is one transaction, durable when the call returns, and
/// idempotent: a repeated call (acknowledgement lost in a crash) leaves the same rows.
/// Every function throws SqliteError naming file, SQL error and code; nothing is half written then.
namespace softwall::campaign {

/// A case as the store remembers it.
struct CaseRecord {
  std::string case_id, label, directory;
  bool is_precursor = false;
  CaseState state = CaseState::kNew;
  std::string state_reason;
  double reached_time = 0.0;      ///< furthest time of an attempt that finished [h/U_b]
  std::int64_t reached_step = 0;  ///< and its step
  double seconds_per_step = 0.0;  ///< wall clock of the newest attempt; 0: not known
  int measured_ranks = 0;         ///< on which that was measured
  std::string state_since;        ///< ISO 8601 UTC
  std::string checkpoints_seen;   ///< when they were last looked at, ISO 8601 UTC; empty: there were none
  bool had_checkpoints = false;   ///< of a later step than the first
  std::string stale_reason;       ///< empty: not stale
  int attempts = 0;
  /// Failed attempts since the case last got further than ever before (or was forgiven). Attempts that were
  /// interrupted on request, never started, or lost with their manager or node do not count: not the case's
  /// fault.
  int attempts_without_progress = 0;
};

/// An attempt without an end: it runs, or a manager that died has left it.
struct OpenAttempt {
  std::string case_id;
  int attempt = 0;
};

/// Which analysis made the stored result of a case; tells whether it has to be made again.
struct ResultOrigin {
  int analysis_version = 0;
  double window_start = 0.0, window_end = 0.0;  ///< [h/U_b]
  std::optional<double> window_asked;           ///< where the window was to start [h/U_b]; empty: not known
  std::string recorded;                         ///< ISO 8601 UTC
};

class Store {
 public:
  /// Opens results.db of a campaign directory. The directory must exist.
  [[nodiscard]] static Store open(const std::filesystem::path& campaign_directory, OpenMode mode);
  /// All of it in memory, to be changed at will.
  [[nodiscard]] static Store copy_in_memory(const std::filesystem::path& campaign_directory);

  /// The campaign row and all its cases in one transaction. New cases get state new; of known ones only
  /// label, directory and run parameters are renewed, and states, attempts and results stay. Cases of an
  /// earlier, larger sweep stay too, with in_campaign = 0.
  void record_campaign(const Campaign& campaign);
  /// Cases of an earlier version of the campaign file, found in their run directories: with in_campaign = 0.
  void record_left_over(const std::vector<CampaignCase>& cases);
  /// Removes all that is known of a case that is no longer part of the campaign.
  void forget(const std::string& case_id);
  void set_state(const std::string& case_id, CaseState state, const std::string& reason);
  /// Marks the cases that another version of the solver has computed, wholly or in part, and takes the mark
  /// from all others. Nothing is computed again unasked.
  void mark_stale(const std::string& version_now);
  /// The user asks for another try: attempts so far no longer count as attempts without progress.
  void forgive(const std::string& case_id);

  /// The intent, before the launch: returns the new attempt's number (1, 2, ...) and sets the case running.
  [[nodiscard]] int begin_attempt(const std::string& case_id, const AttemptStart& start);
  /// After the launch. handle: by which its launcher finds the attempt again.
  void attempt_started(const std::string& case_id, int attempt, const std::string& handle);
  /// May be repeated: the last call wins. Does not change the state of the case.
  void end_attempt(const std::string& case_id, int attempt, const AttemptEnd& end);
  /// Writes an attempt found in a run directory but not in the store (store lost): start and end at once.
  void restore_attempt(const std::string& case_id, int attempt, const AttemptStart& start,
                       const AttemptEnd& end);
  /// The same of an attempt that has not ended; the case is running.
  void restore_open_attempt(const std::string& case_id, int attempt, const AttemptStart& start,
                            const std::string& handle);

  /// The whole ladder as found now; checkpoints recorded earlier and no longer listed are kept as removed.
  void record_checkpoints(const std::string& case_id, const std::vector<CheckpointRecord>& ladder);
  /// Replaces the result of a case. git_revision: of the manager that analysed.
  void record_result(const std::string& case_id, const analysis::DerivedQuantities& derived,
                     const std::string& git_revision);
  /// The case is then one without a result.
  void remove_result(const std::string& case_id);

  [[nodiscard]] std::optional<CaseRecord> find_case(const std::string& case_id) const;
  /// All cases, by id.
  [[nodiscard]] std::unordered_map<std::string, CaseRecord> all_cases() const;
  [[nodiscard]] int attempts(const std::string& case_id) const;
  [[nodiscard]] std::vector<OpenAttempt> open_attempts(const std::string& case_id) const;
  /// Attempts that have ended, in order.
  [[nodiscard]] std::vector<PastAttempt> past_attempts(const std::string& case_id) const;
  /// Wall-clock time times ranks of all attempts [h], by case id.
  [[nodiscard]] std::map<std::string, double> core_hours() const;
  [[nodiscard]] std::optional<ResultOrigin> result_origin(const std::string& case_id) const;
  /// Of all cases that have a result, by id.
  [[nodiscard]] std::unordered_map<std::string, ResultOrigin> result_origins() const;

  [[nodiscard]] Connection& connection() { return connection_; }

 private:
  [[nodiscard]] bool has_recorded(const Campaign& campaign) const;
  explicit Store(Connection connection) : connection_(std::move(connection)) {}
  mutable Connection connection_;
};

}  // namespace softwall::campaign
