#include "campaign/store/store.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "campaign/core/words.hpp"
#include "campaign/store/backup.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {

namespace {

/// Throws when the last statement found no row: a case or attempt that is not there is an error.
void require_row(const Connection& connection, const std::string& what) {
  if (connection.changes() == 0) throw SqliteError(connection.file().string() + ": no " + what + " in it", 0);
}

std::string attempt_name(const std::string& case_id, int attempt) {
  return "attempt " + std::to_string(attempt) + " of case " + case_id;
}

/// "72x60+24x64": the solid's cells set apart, because they lie beyond the channel's height.
std::string grid_text(const GridSpec& grid) {
  std::string text = std::to_string(grid.nx) + "x" + std::to_string(grid.ny_fluid);
  if (grid.ny_solid > 0) text += "+" + std::to_string(grid.ny_solid);
  return text + "x" + std::to_string(grid.nz);
}

std::int64_t cell_count(const GridSpec& grid) { return std::int64_t{1} * grid.nx * grid.ny() * grid.nz; }

std::optional<std::string> if_any(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

void write_case(Connection& connection, const CampaignCase& campaign_case) {
  const Case& definition = campaign_case.definition;
  const Physics& physics = definition.physics;
  const nlohmann::json document = to_json(definition);
  std::optional<double> modulus, viscosity_ratio;
  if (physics.solid) {
    modulus = physics.solid->G;
    viscosity_ratio = physics.solid->viscosity_ratio;
  }
  connection.run(
      "INSERT INTO cases (case_id, label, directory, is_precursor, precursor_id, flow, G, viscosity_ratio,"
      " reynolds, grid, cells, end_time, ranks, physics, run, state_since, created, varied)"
      " VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?16, ?17)"
      " ON CONFLICT (case_id) DO UPDATE SET label = excluded.label, directory = excluded.directory,"
      " is_precursor = excluded.is_precursor, precursor_id = excluded.precursor_id,"
      " end_time = excluded.end_time, ranks = excluded.ranks, physics = excluded.physics,"
      " run = excluded.run, varied = excluded.varied, in_campaign = 1",
      definition.id, definition.label, campaign_case.directory, campaign_case.is_precursor,
      if_any(campaign_case.precursor_id), document.at("physics").at("flow").get<std::string>(), modulus,
      viscosity_ratio, physics.reynolds, grid_text(physics.grid), cell_count(physics.grid),
      definition.run.end_time, campaign_case.ranks, document.at("physics").dump(), document.at("run").dump(),
      utc_now(), campaign_case.varied);
}

void write_state(Connection& connection, const std::string& case_id, CaseState state,
                 const std::string& reason) {
  connection.run(
      "UPDATE cases SET state_since = iif(state = ?2, state_since, ?4), state = ?2, state_reason = ?3"
      " WHERE case_id = ?1",
      case_id, word_of(state), reason, utc_now());
  require_row(connection, "case " + case_id);
}

void write_diagnostics(Connection& connection, const std::string& case_id, int attempt,
                       const std::map<std::string, double>& diagnostics) {
  connection.run("DELETE FROM diagnostics WHERE case_id = ? AND attempt = ?", case_id, attempt);
  for (const auto& [name, value] : diagnostics) {
    connection.run("INSERT INTO diagnostics (case_id, attempt, name, value) VALUES (?, ?, ?, ?)", case_id,
                   attempt, name, value);
  }
}

/// Leaves an attempt alone that is there.
void insert_attempt(Connection& connection, const std::string& case_id, int attempt,
                    const AttemptStart& start, const std::string& intended) {
  connection.run(
      "INSERT INTO attempts (case_id, attempt, intended, host, ranks, resumed_from) VALUES (?, ?, ?, ?, ?, ?)"
      " ON CONFLICT (case_id, attempt) DO NOTHING",
      case_id, attempt, intended, start.host, start.ranks, if_any(start.resumed_from));
}

void write_end(Connection& connection, const std::string& case_id, int attempt, const AttemptEnd& end) {
  connection.run(
      "UPDATE attempts SET started = coalesce(?3, started), ended = ?4, outcome = ?5, reason = ?6,"
      " exit_code = ?7, step = ?8, time = ?9, attempt_steps = ?10, wall_seconds = ?11, ns_per_cell_step = "
      "?12,"
      " version = ?13, git_revision = ?14, build_type = ?15, compiler = ?16"
      " WHERE case_id = ?1 AND attempt = ?2",
      case_id, attempt, if_any(end.started), end.ended.empty() ? utc_now() : end.ended, word_of(end.outcome),
      end.reason, end.exit_code, end.step, end.time, end.attempt_steps, end.wall_seconds,
      end.ns_per_cell_step, if_any(end.version), if_any(end.git_revision), if_any(end.build_type),
      if_any(end.compiler));
  require_row(connection, attempt_name(case_id, attempt));
  if (const auto& began = end.began)
    connection.run(
        "UPDATE attempts SET host = ?3, ranks = ?4, resumed_from = ?5 WHERE case_id = ?1 AND attempt = ?2",
        case_id, attempt, began->host, began->ranks, if_any(began->resumed_from));
  write_diagnostics(connection, case_id, attempt, end.diagnostics);
}

void write_checkpoint(Connection& connection, const std::string& case_id,
                      const CheckpointRecord& checkpoint) {
  connection.run(
      "INSERT INTO checkpoints (case_id, path, step, time, bytes, digest, valid, reason, present, first_seen,"
      " seen) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, 1, ?9, ?9)"
      " ON CONFLICT (case_id, path) DO UPDATE SET step = excluded.step, time = excluded.time,"
      " bytes = excluded.bytes, digest = excluded.digest, valid = excluded.valid, reason = excluded.reason,"
      " present = 1, seen = excluded.seen",
      case_id, checkpoint.path, checkpoint.step, checkpoint.time, checkpoint.bytes, checkpoint.digest,
      checkpoint.valid, checkpoint.reason, utc_now());
}

}  // namespace

Store Store::open(const std::filesystem::path& campaign_directory, OpenMode mode) {
  return Store(open_store_file(campaign_directory, mode));
}

Store Store::copy_in_memory(const std::filesystem::path& campaign_directory) {
  Connection file = open_store_file(campaign_directory, OpenMode::kReadOnly);
  return Store(softwall::campaign::copy_in_memory(file));
}

/// Whether the store holds this very campaign, so that not one of its cases has to be written.
bool Store::has_recorded(const Campaign& campaign) const {
  Statement spec = connection_.prepare("SELECT spec FROM campaign");
  if (!spec.step() || spec.text(0) != campaign.spec_text) return false;
  std::unordered_map<std::string, std::array<std::string, 3>> known;
  Statement rows =
      connection_.prepare("SELECT case_id, label, directory, varied FROM cases WHERE in_campaign = 1");
  while (rows.step()) known[rows.text(0)] = {rows.text(1), rows.text(2), rows.text(3)};
  return known.size() == campaign.cases.size() &&
         std::ranges::all_of(campaign.cases, [&](const CampaignCase& one) {
           const auto found = known.find(one.definition.id);
           return found != known.end() &&
                  found->second == std::array{one.definition.label, one.directory, one.varied};
         });
}

void Store::record_campaign(const Campaign& campaign) {
  if (has_recorded(campaign)) return;
  Transaction transaction(connection_);
  connection_.run(
      "INSERT INTO campaign (id, name, spec, created, updated) VALUES (1, ?1, ?2, ?3, ?3)"
      " ON CONFLICT (id) DO UPDATE SET name = excluded.name, spec = excluded.spec, updated = "
      "excluded.updated",
      campaign.name, campaign.spec_text, utc_now());
  connection_.run("UPDATE cases SET in_campaign = 0");
  for (const CampaignCase& campaign_case : campaign.cases) write_case(connection_, campaign_case);
  transaction.commit();
}

void Store::record_left_over(const std::vector<CampaignCase>& cases) {
  Transaction transaction(connection_);
  for (const CampaignCase& one : cases) {
    write_case(connection_, one);
    connection_.run("UPDATE cases SET in_campaign = 0 WHERE case_id = ?", one.definition.id);
  }
  transaction.commit();
}

void Store::forget(const std::string& case_id) {
  Transaction transaction(connection_);
  for (const char* table : {"diagnostics", "attempts", "checkpoints", "quantities"}) {
    connection_.run(std::string("DELETE FROM ") + table + " WHERE case_id = ?", case_id);
  }
  connection_.run("DELETE FROM cases WHERE case_id = ? AND in_campaign = 0", case_id);
  transaction.commit();
}

void Store::set_state(const std::string& case_id, CaseState state, const std::string& reason) {
  Transaction transaction(connection_);
  write_state(connection_, case_id, state, reason);
  transaction.commit();
}

void Store::mark_stale(const std::string& version_now) {
  connection_.run(
      "UPDATE cases SET stale_reason = now.reason FROM ("
      " SELECT c.case_id, coalesce('computed by version ' || group_concat(DISTINCT a.version) ||"
      "  ', this is ' || ?1, '') AS reason"
      " FROM cases c LEFT JOIN attempts a ON a.case_id = c.case_id AND a.version <> ?1"
      " GROUP BY c.case_id) now"
      " WHERE cases.case_id = now.case_id AND cases.stale_reason <> now.reason",
      version_now);
}

void Store::forgive(const std::string& case_id) {
  Transaction transaction(connection_);
  connection_.run(
      "UPDATE cases SET forgiven = (SELECT coalesce(max(attempt), 0) FROM attempts WHERE case_id = ?1)"
      " WHERE case_id = ?1",
      case_id);
  require_row(connection_, "case " + case_id);
  transaction.commit();
}

int Store::begin_attempt(const std::string& case_id, const AttemptStart& start) {
  Transaction transaction(connection_);
  const int attempt = attempts(case_id) + 1;
  write_state(connection_, case_id, CaseState::kRunning, "attempt " + std::to_string(attempt));
  insert_attempt(connection_, case_id, attempt, start, utc_now());
  transaction.commit();
  return attempt;
}

void Store::attempt_started(const std::string& case_id, int attempt, const std::string& handle) {
  Transaction transaction(connection_);
  connection_.run("UPDATE attempts SET started = ?3, handle = ?4 WHERE case_id = ?1 AND attempt = ?2",
                  case_id, attempt, utc_now(), handle);
  require_row(connection_, attempt_name(case_id, attempt));
  transaction.commit();
}

void Store::end_attempt(const std::string& case_id, int attempt, const AttemptEnd& end) {
  Transaction transaction(connection_);
  write_end(connection_, case_id, attempt, end);
  transaction.commit();
}

void Store::restore_attempt(const std::string& case_id, int attempt, const AttemptStart& start,
                            const AttemptEnd& end) {
  Transaction transaction(connection_);
  insert_attempt(connection_, case_id, attempt, start, end.started.empty() ? utc_now() : end.started);
  write_end(connection_, case_id, attempt, end);
  transaction.commit();
}

void Store::restore_open_attempt(const std::string& case_id, int attempt, const AttemptStart& start,
                                 const std::string& handle) {
  Transaction transaction(connection_);
  write_state(connection_, case_id, CaseState::kRunning, "attempt " + std::to_string(attempt));
  insert_attempt(connection_, case_id, attempt, start, utc_now());
  attempt_started(case_id, attempt, handle);
  transaction.commit();
}

void Store::record_checkpoints(const std::string& case_id, const std::vector<CheckpointRecord>& ladder) {
  Transaction transaction(connection_);
  connection_.run("UPDATE checkpoints SET present = 0 WHERE case_id = ?", case_id);
  for (const CheckpointRecord& checkpoint : ladder) write_checkpoint(connection_, case_id, checkpoint);
  transaction.commit();
}

}  // namespace softwall::campaign
