#include "campaign/commands/verify_store.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "analysis/derived.hpp"
#include "campaign/observe/averages.hpp"
#include "campaign/observe/ladder.hpp"
#include "campaign/store/import_results.hpp"
#include "campaign/store/store_schema.hpp"
#include "solver/case/case_schema.hpp"
#include "solver/run_directory/build_info.hpp"
#include "solver/run_directory/statistics_file.hpp"

namespace softwall::campaign {
namespace {

/// What follows from the id of a case, whatever the campaign file says now.
constexpr const char* kPhysicsOfCase =
    "SELECT flow, G, viscosity_ratio, reynolds, grid, cells, stale = (stale_reason <> '') AS stale"
    " FROM cases WHERE case_id = ?";

/// What the campaign file says of it.
constexpr const char* kPlanOfCase =
    "SELECT label, directory, is_precursor, precursor_id, end_time, ranks, in_campaign"
    " FROM cases WHERE case_id = ?";

constexpr const char* kDocumentsOfCase = "SELECT physics, run, varied FROM cases WHERE case_id = ?";

constexpr const char* kResult =
    "SELECT quantity, value, ci95, window_start, window_end, blocks, analysis_version, note FROM quantities"
    " WHERE case_id = ? ORDER BY quantity";

/// The same without the note, whose words may change with the program.
constexpr const char* kQuantity =
    "SELECT quantity, value, ci95, window_start, window_end, blocks, analysis_version FROM quantities"
    " WHERE case_id = ? AND quantity = ?";

/// One result is one row a quantity, each with its origin: all of them tell the same.
constexpr const char* kOriginsOfResult =
    "SELECT DISTINCT window_start, window_end, blocks, note, analysis_version, git_revision, recorded"
    " FROM quantities WHERE case_id = ?";

constexpr const char* kViews = "SELECT name, sql FROM sqlite_schema WHERE type = 'view' ORDER BY name";
constexpr const char* kColumns =
    "SELECT t.name, c.name, c.type, c.\"notnull\", c.hidden"
    " FROM sqlite_schema t JOIN pragma_table_xinfo(t.name) c WHERE t.type = 'table' ORDER BY t.name, c.name";
constexpr const char* kDocumentation =
    "SELECT object, column_name, unit, meaning FROM documentation ORDER BY object, column_name";

/// One of the two documents of a case in the store, with the defaults of members that its writer did not
/// know; null where it is no JSON any more.
nlohmann::json document_in(const Statement& row, int column, const char* name) {
  nlohmann::json written = nlohmann::json::parse(row.text(column), nullptr, false);
  if (written.is_discarded()) return nullptr;
  nlohmann::json document = {{name, std::move(written)}};
  case_schema().fill_defaults(document);
  return document.at(name);
}

/// How far a number may be from the one expected. The same program gives the same bits; one of another
/// revision, perhaps built for another processor, agrees to round-off.
enum class Agreement { kBits, kRoundOff };

bool same_number(double a, double b, Agreement agreement) {
  constexpr double kRelative = 1e-9, kAbsolute = 1e-12;
  if (agreement == Agreement::kBits) return a == b;
  return std::abs(a - b) <= kAbsolute + kRelative * std::abs(b);
}

bool same_cell(const Statement& a, const Statement& b, int column, Agreement agreement) {
  if (a.type(column) != b.type(column)) return false;
  return a.type(column) == SQLITE_FLOAT ? same_number(a.real(column), b.real(column), agreement)
                                        : a.text(column) == b.text(column);
}

/// The first column in which two answers to one question differ; empty: none.
std::string first_difference(Statement a, Statement b, Agreement agreement = Agreement::kBits) {
  while (a.step()) {
    if (!b.step()) return "number of rows";
    for (int column = 0; column < a.columns(); ++column)
      if (!same_cell(a, b, column, agreement)) return a.column_name(column);
  }
  return b.step() ? "number of rows" : "";
}

auto members_of(const PastAttempt& past) {
  const AttemptEnd& end = past.end;
  return std::tie(past.start.host, past.start.ranks, past.start.resumed_from, end.outcome, end.reason,
                  end.exit_code, end.step, end.time, end.attempt_steps, end.wall_seconds,
                  end.ns_per_cell_step, end.started, end.ended, end.version, end.git_revision, end.build_type,
                  end.compiler, end.diagnostics);
}

auto members_of(const CheckpointRecord& record) {
  return std::tie(record.path, record.step, record.time, record.bytes, record.digest, record.valid);
}

/// As the store has them: those that it takes for whole and present.
std::vector<CheckpointRecord> stored_checkpoints(Store& store, const std::string& case_id) {
  Statement rows = store.connection().query(
      "SELECT path, step, time, bytes, digest FROM checkpoints"
      " WHERE case_id = ? AND present = 1 AND valid = 1 ORDER BY path DESC",
      case_id);
  std::vector<CheckpointRecord> records;
  while (rows.step()) {
    CheckpointRecord record;
    record.path = rows.text(0);
    record.step = rows.integer(1);
    record.time = rows.real(2);
    record.bytes = rows.integer(3);
    record.digest = rows.text(4);
    record.valid = true;
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace

StoreCheck::StoreCheck(Store& store, const LoadedCampaign& loaded)
    : store_(store), expected_(Store::copy_in_memory(loaded.folder)) {
  Statement spec = store_.connection().prepare("SELECT spec FROM campaign");
  same_campaign_ = spec.step() && spec.text(0) == loaded.campaign.spec_text;
  Connection& memory = expected_.connection();
  memory.execute("PRAGMA foreign_keys = OFF; DELETE FROM cases; DELETE FROM campaign");
  expected_.record_campaign(loaded.campaign);
}

std::string StoreCheck::trouble_with_words() {
  Connection fresh = Connection::open_in_memory();
  create_schema(fresh);
  for (const auto& [what, question] : {std::pair("views", kViews), std::pair("columns", kColumns),
                                       std::pair("page of documentation", kDocumentation)}) {
    if (!first_difference(store_.connection().prepare(question), fresh.prepare(question)).empty())
      return std::string("its ") + what + " are not those of this program";
  }
  if (same_campaign_ && !first_difference(store_.connection().prepare("SELECT name FROM campaign"),
                                          expected_.connection().prepare("SELECT name FROM campaign"))
                             .empty())
    return "has another name for the campaign than its file";
  return "";
}

std::string StoreCheck::trouble_with_case(const CampaignCase& one, const RunFiles& run) {
  const std::string& id = one.definition.id;
  if (!store_.find_case(id)) {
    const bool has_begun = std::filesystem::exists(run.directory);
    return same_campaign_ && has_begun ? "has no row in the store" : "";
  }
  if (auto found = difference_in_case_row(id); !found.empty()) return found;
  if (!store_.open_attempts(id).empty()) return "";  // its end is recorded by the next run
  if (auto found = difference_in_attempts(id, run); !found.empty()) return found;
  if (auto found = difference_in_checkpoints(id, run); !found.empty()) return found;
  return difference_in_result(one, run);
}

std::string StoreCheck::difference_in_case_row(const std::string& case_id) {
  const auto difference = [&](const char* question) {
    return first_difference(store_.connection().query(question, case_id),
                            expected_.connection().query(question, case_id));
  };
  std::string found = difference(kPhysicsOfCase);
  if (found.empty() && same_campaign_) found = difference(kPlanOfCase);
  if (found.empty()) found = difference_in_documents(case_id);
  return found.empty() ? "" : "the store has another " + found + " than the campaign file gives";
}

/// Which of the documents of a case differs: what it is, and, of the same campaign, how it is run. An earlier
/// version wrote them without the members that came later.
std::string StoreCheck::difference_in_documents(const std::string& case_id) {
  Statement stored = store_.connection().query(kDocumentsOfCase, case_id),
            given = expected_.connection().query(kDocumentsOfCase, case_id);
  if (!stored.step() || !given.step()) return "number of rows";
  if (document_in(stored, 0, "physics") != document_in(given, 0, "physics")) return "physics";
  const bool knows_what_varied = stored.text(2) != "{}";  // a store of the first format does not
  if (same_campaign_ && knows_what_varied && stored.text(2) != given.text(2)) return "varied";
  if (same_campaign_ && document_in(stored, 1, "run") != document_in(given, 1, "run")) return "run";
  return "";
}

/// A run directory of an earlier version knows the newest attempt only, and others compare that one.
std::string StoreCheck::difference_in_attempts(const std::string& case_id, const RunFiles& run) const {
  const auto stored = store_.past_attempts(case_id);
  for (const PastAttempt& told : read_history(run, case_id)) {
    const auto same = [&](const PastAttempt& each) { return each.attempt == told.attempt; };
    const auto found = std::ranges::find_if(stored, same);
    if (found == stored.end() || members_of(*found) != members_of(told))
      return "the store tells otherwise of attempt " + std::to_string(told.attempt) + " than history.json";
  }
  return "";
}

std::string StoreCheck::difference_in_checkpoints(const std::string& case_id, const RunFiles& run) {
  auto there = checkpoint_records(run);
  std::erase_if(there, [](const CheckpointRecord& record) { return !record.valid; });
  const auto stored = stored_checkpoints(store_, case_id);
  const bool same = std::ranges::equal(
      stored, there, [](const auto& a, const auto& b) { return members_of(a) == members_of(b); });
  return same ? "" : "the store tells otherwise of its checkpoints than their headers";
}

std::string StoreCheck::difference_in_result(const CampaignCase& one, const RunFiles& run) {
  const std::string& id = one.definition.id;
  Statement origins = store_.connection().query(kOriginsOfResult, id);
  if (!origins.step()) return "";  // there is no result
  const bool same_program = origins.text(5) == build_info().git_revision;
  if (origins.step()) return "the rows of its result do not agree about where it is from";
  const auto origin = store_.result_origin(id);
  if (!origin || origin->analysis_version != analysis::kAnalysisVersion) return "";
  try {
    const auto statistics = analysis::read_statistics(run.statistics());
    const auto derived = analysis::derive(statistics, window_from(origin->window_asked.value_or(0)));
    expected_.record_result(id, derived, "");
  } catch (const SqliteError&) {
    throw;
  } catch (const std::runtime_error&) {
    return "";  // others tell what is wrong with the statistics
  }
  const std::string found = same_program ? first_difference(store_.connection().query(kResult, id),
                                                            expected_.connection().query(kResult, id))
                                         : difference_in_quantities(id);
  return found.empty() ? "" : "the store has another " + found + " of a quantity than its statistics give";
}

/// An earlier program knew fewer quantities: those that it recorded.
std::string StoreCheck::difference_in_quantities(const std::string& case_id) {
  Statement names = store_.connection().query("SELECT quantity FROM quantities WHERE case_id = ?", case_id);
  while (names.step()) {
    const std::string name = names.text(0);
    const std::string found =
        first_difference(store_.connection().query(kQuantity, case_id, name),
                         expected_.connection().query(kQuantity, case_id, name), Agreement::kRoundOff);
    if (!found.empty()) return found;
  }
  return "";
}

}  // namespace softwall::campaign
