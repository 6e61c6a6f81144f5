#include <iostream>
#include <optional>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/findings.hpp"
#include "campaign/commands/verify_record.hpp"
#include "campaign/commands/verify_store.hpp"
#include "campaign/launch/make_launcher.hpp"
#include "campaign/observe/averages.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/store/store.hpp"
#include "schemas/embedded.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/input_file.hpp"
#include "solver/case/json_schema.hpp"
#include "solver/case/json_text.hpp"
#include "solver/case/spelling.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "solver/run_directory/statistics_file.hpp"

namespace softwall::campaign {
namespace {

std::string trouble_with_statistics(const RunFiles& run, const std::string& case_id) {
  try {
    const auto statistics = analysis::read_statistics(run.statistics());
    if (!statistics.case_id.empty() && statistics.case_id != case_id)
      return "belongs to case " + statistics.case_id;
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

/// The first mistake of a JSON file against its schema; empty when there is none, or no such file.
std::string trouble_with_json(const std::filesystem::path& file, std::string_view schema) {
  if (!std::filesystem::exists(file)) return "";
  try {
    const auto mistakes = JsonSchema(schema).mistakes(parse_json(read_input_file(file), file.string()));
    if (mistakes.empty()) return "";
    const Mistake& first = mistakes.front();
    return first.where + ": " + first.given + "; " + first.allowed;
  } catch (const BadInput& error) {
    return error.what();
  }
}

/// case.json is the case that it says to be, and the one that this directory is for.
std::string trouble_with_case(const RunFiles& run, const std::string& case_id) {
  // Where the disk was full the first time, the folder is all that there is.
  if (!std::filesystem::exists(run.case_file()))
    return std::filesystem::exists(run.run_record()) || !checkpoint_ladder(run).empty() ? "is missing" : "";
  if (auto trouble = trouble_with_json(run.case_file(), schemas::kCaseSchema); !trouble.empty())
    return trouble;
  try {
    const std::string id = read_case(run.case_file()).id;
    return id == case_id ? "" : "describes case " + id + ", not " + case_id;
  } catch (const BadInput& error) {
    return error.what();
  }
}

std::string trouble_with_summary(const RunFiles& run, const std::string& case_id) {
  return read_summary(run, case_id) ? trouble_with_json(run.summary(), schemas::kSummarySchema)
                                    : "cannot be read, or is not of case " + case_id;
}

std::string trouble_with_run_record(const RunFiles& run, const std::string& case_id) {
  if (!std::filesystem::exists(run.run_record())) return "is missing";
  if (auto trouble = trouble_with_json(run.run_record(), schemas::kRunSchema); !trouble.empty())
    return trouble;
  const auto record = read_run_record(run);
  return record && record->case_id == case_id ? "" : "cannot be read, or is not of case " + case_id;
}

/// Whether the newest attempt was recorded as started, which is done after run.json is written: a runner that
/// is killed between the launch and that leaves an attempt without either.
bool has_handle(Store& store, const std::string& case_id) {
  Statement row = store.connection().query(
      "SELECT handle FROM attempts WHERE case_id = ? ORDER BY attempt DESC LIMIT 1", case_id);
  return row.step() && !row.is_null(0);
}

/// What a damaged checkpoint means for a case that has finished, of which nobody reads it unasked.
std::string meaning_for_finished(const CampaignCase& one, bool another_is_good) {
  if (!another_is_good) return "; the case has finished and its results stand, but it could not go on";
  if (one.starts_others)
    return "; the next case that starts from it makes softwall run compute it again from the one before";
  return "; the case has finished and its results stand; with a later end time it goes on from another one";
}

/// An attempt that ends in order writes a checkpoint of the step that its summary tells.
std::string trouble_with_newest(const RunFiles& run, const std::string& case_id) {
  const auto summary = read_summary(run, case_id);
  if (!summary || (summary->outcome != "finished" && summary->outcome != "interrupted")) return "";
  if (std::filesystem::exists(run.checkpoint(summary->step))) return "";
  return "that of step " + std::to_string(summary->step) + ", with which the last attempt ended, is missing";
}

/// A case may finish without any average in its window: then there is no result to store.
std::string trouble_with_result(const Store& store, const CampaignCase& one, const RunFiles& run) {
  if (store.result_origin(one.definition.id)) return "";
  return averages_so_far(one, run) ? "the store has no result of it" : "";
}

class Verification {
 public:
  Verification(const LoadedCampaign& loaded, Findings& findings) : loaded_(loaded), findings_(findings) {
    if (std::filesystem::exists(store_path(loaded.folder)))
      store_ = open_store();
    else if (std::filesystem::exists(loaded.folder / "cases"))
      tell_of_store("", "is missing; softwall rebuild makes it again");
    if (store_) check_store();
  }

  void check(const CampaignCase& one, const RunFiles& run, bool busy) {
    try {
      check_files(one, run, busy);
    } catch (const std::system_error& error) {
      findings_.add(one.directory, error.what());
    }
  }

 private:
  void check_files(const CampaignCase& one, const RunFiles& run, bool busy) {
    const std::string& id = one.definition.id;
    if (rows_ && !busy) tell_of_store(one.definition.label + ": ", rows_->trouble_with_case(one, run));
    if (!std::filesystem::exists(run.directory)) return;
    const auto tell = [&](const std::filesystem::path& file, const std::string& trouble) {
      findings_.add(one.directory + "/" + file.lexically_relative(run.directory).string(), trouble);
    };
    check_checkpoints(one, run, busy, tell);
    tell(run.case_file(), trouble_with_case(run, id));
    if (std::filesystem::exists(run.status()))
      tell(run.status(), trouble_with_json(run.status(), schemas::kStatusSchema));
    if (std::filesystem::exists(run.summary())) tell(run.summary(), trouble_with_summary(run, id));
    if (!busy) check_at_rest(one, run, tell);
  }

  template <class Tell>
  void check_checkpoints(const CampaignCase& one, const RunFiles& run, bool busy, const Tell& tell) {
    std::vector<std::pair<std::filesystem::path, std::string>> damaged;
    bool one_is_good = false;
    for (const auto& file : checkpoint_ladder(run)) {
      const CheckpointVerdict verdict = verify_checkpoint(file, one.definition.id);
      // The solver at work removes the oldest whenever it has written one.
      if (!verdict.valid && busy && !std::filesystem::exists(file)) continue;
      one_is_good = one_is_good || verdict.valid;
      if (verdict.valid)
        tell(file, "");
      else
        damaged.emplace_back(file, verdict.reason);
    }
    const bool done = !busy && !damaged.empty() && observe_files(one, run).state == CaseState::kFinished;
    for (const auto& [file, reason] : damaged)
      tell(file, reason + (done ? meaning_for_finished(one, one_is_good) : ""));
  }

  /// Compares files that agree only while nobody writes.
  template <class Tell>
  void check_at_rest(const CampaignCase& one, const RunFiles& run, const Tell& tell) {
    const std::string& id = one.definition.id;
    if (store_ && !std::filesystem::exists(run.summary()))
      tell(run.summary(), trouble_with_no_summary(*store_, id));
    if (std::filesystem::exists(run.summary())) {
      if (std::filesystem::exists(run.run_record()) || (store_ && has_handle(*store_, id)))
        tell(run.run_record(), trouble_with_run_record(run, id));
      tell(run.checkpoints(), trouble_with_newest(run, id));
      if (store_) tell(run.summary(), difference_of_attempt(*store_, one, run));
    }
    if (observe_files(one, run).state != CaseState::kFinished) return;
    tell(run.statistics(), trouble_with_statistics(run, id));
    if (store_) tell(run.statistics(), trouble_with_result(*store_, one, run));
  }

  void check_store() {
    try {
      rows_.emplace(*store_, loaded_);
      tell_of_store("", rows_->trouble_with_words());
    } catch (const SqliteError& error) {
      tell_of_store("", error.what());
    }
  }

  /// One file, of which there may be something to tell for every case.
  void tell_of_store(const std::string& where, const std::string& trouble) {
    if (!trouble.empty()) findings_.add("results.db", where + trouble);
  }

  std::optional<Store> open_store() {
    try {
      Store store = Store::open(loaded_.folder, OpenMode::kReadOnly);
      Statement check = store.connection().prepare("PRAGMA integrity_check(1)");
      const std::string verdict = check.step() ? check.text(0) : "no answer";
      findings_.add("results.db", verdict == "ok" ? "" : verdict);
      return store;
    } catch (const SqliteError& error) {
      findings_.add("results.db", error.what());
      return std::nullopt;
    }
  }

  const LoadedCampaign& loaded_;
  Findings& findings_;
  std::optional<Store> store_;
  std::optional<StoreCheck> rows_;
};

std::vector<const CampaignCase*> choose(const Campaign& campaign, const std::optional<std::string>& chosen) {
  std::vector<const CampaignCase*> cases;
  std::vector<std::string> labels;
  for (const CampaignCase& one : campaign.cases) {
    labels.push_back(one.definition.label);
    if (!chosen || one.definition.label == *chosen || one.definition.id.starts_with(*chosen))
      cases.push_back(&one);
  }
  if (!cases.empty()) return cases;
  const auto near = suggestion(*chosen, labels);
  throw BadInput(campaign.name, {{"", "no case " + printable_excerpt(*chosen),
                                  near ? "perhaps " + *near : "a label, or the beginning of a case id"}});
}

}  // namespace

ExitStatus verify_campaign(const std::filesystem::path& path, const std::optional<std::string>& chosen) {
  const LoadedCampaign loaded = load_campaign(path);
  Findings findings;
  const auto cases = choose(loaded.campaign, chosen);
  std::vector<RunFiles> runs;
  for (const CampaignCase* one : cases) runs.push_back(run_files(loaded.folder, *one));
  // Whoever runs it starts one case while we look at another.
  const bool owned = living_owner(loaded.folder).has_value() || owner_is_unknown(loaded.folder);
  const auto busy = occupied(runs, *make_launcher(loaded.campaign.execution));
  Verification verification(loaded, findings);
  for (std::size_t i = 0; i < cases.size(); ++i) verification.check(*cases[i], runs[i], owned || busy[i]);
  std::cout << findings.checked << " files checked, " << findings.wrong << " bad." << std::endl;
  return findings.wrong == 0 ? ExitStatus::kDone : ExitStatus::kFailedCases;
}

}  // namespace softwall::campaign
