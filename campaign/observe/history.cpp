#include "campaign/observe/history.hpp"

#include <fstream>
#include <optional>

#include <nlohmann/json.hpp>

#include "campaign/core/words.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/case/json_text.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;

std::filesystem::path history_file(const RunFiles& run) { return run.directory / "history.json"; }

template <class T>
json if_known(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

json to_object(const PastAttempt& past) {
  const AttemptEnd& end = past.end;
  return {{"attempt", past.attempt},
          {"host", past.start.host},
          {"ranks", past.start.ranks},
          {"resumed_from", past.start.resumed_from},
          {"outcome", word_of(end.outcome)},
          {"reason", end.reason},
          {"exit_code", if_known(end.exit_code)},
          {"step", if_known(end.step)},
          {"time", if_known(end.time)},
          {"attempt_steps", if_known(end.attempt_steps)},
          {"wall_seconds", if_known(end.wall_seconds)},
          {"ns_per_cell_step", if_known(end.ns_per_cell_step)},
          {"started", end.started},
          {"ended", end.ended},
          {"version", end.version},
          {"git_revision", end.git_revision},
          {"build_type", end.build_type},
          {"compiler", end.compiler},
          {"diagnostics", end.diagnostics}};
}

PastAttempt from_object(const json& object) {
  PastAttempt past;
  past.attempt = object.at("attempt");
  past.start = {object.at("host"), object.at("ranks"), object.at("resumed_from")};
  AttemptEnd& end = past.end;
  end.outcome = outcome_of(object.at("outcome").get<std::string>()).value_or(AttemptOutcome::kFailed);
  end.reason = object.at("reason");
  end.exit_code = optional_member<int>(object, "exit_code");
  end.step = optional_member<std::int64_t>(object, "step");
  end.time = optional_member<double>(object, "time");
  end.attempt_steps = optional_member<std::int64_t>(object, "attempt_steps");
  end.wall_seconds = optional_member<double>(object, "wall_seconds");
  end.ns_per_cell_step = optional_member<double>(object, "ns_per_cell_step");
  end.started = object.at("started");
  end.ended = object.at("ended");
  end.version = object.at("version");
  end.git_revision = object.at("git_revision");
  end.build_type = object.at("build_type");
  end.compiler = object.at("compiler");
  for (const auto& [name, value] : object.at("diagnostics").items()) {
    if (value.is_number()) end.diagnostics[name] = value.get<double>();
  }
  return past;
}

}  // namespace

void write_history(const RunFiles& run, const std::string& case_id,
                   const std::vector<PastAttempt>& attempts) {
  json list = json::array();
  for (const PastAttempt& past : attempts) list.push_back(to_object(past));
  const json object = {{"format", kFormat}, {"case_id", case_id}, {"attempts", list}};
  write_atomically(history_file(run), object.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
}

std::vector<PastAttempt> read_history(const RunFiles& run, const std::string& case_id) {
  std::ifstream in(history_file(run));
  if (!in) return {};
  try {
    const json object = json::parse(in);
    if (object.at("format") != kFormat || object.at("case_id") != case_id) return {};
    std::vector<PastAttempt> attempts;
    for (const json& one : object.at("attempts")) attempts.push_back(from_object(one));
    return attempts;
  } catch (const json::exception&) {
    return {};
  }
}

}  // namespace softwall::campaign
