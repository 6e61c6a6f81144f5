#include "campaign/core/spec.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "campaign/core/derive.hpp"
#include "campaign/core/parameters.hpp"
#include "campaign/core/start_order.hpp"
#include "campaign/core/sweep.hpp"
#include "campaign/core/words.hpp"
#include "schemas/embedded.hpp"
#include "solver/case/json_text.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

constexpr const char* kSlurm = "slurm";  // execution.launcher, and the member that belongs to it

SlurmOptions slurm_from(const json& object) {
  SlurmOptions slurm;
  slurm.account = object.value("account", "");
  slurm.partition = object.value("partition", "");
  slurm.time_limit_minutes = optional_member<int>(object, "time_limit_minutes");
  slurm.nodes = optional_member<int>(object, "nodes");
  slurm.cases_per_job = object.at("cases_per_job");
  slurm.signal_seconds = object.at("signal_seconds");
  slurm.start_with = object.at("start_with");
  slurm.start_options = object.at("start_options");
  slurm.options = object.at("options");
  return slurm;
}

Execution execution_from(const json& object) {
  Execution execution;
  execution.launcher = object.at("launcher");
  execution.ranks = object.at("ranks");
  const int precursor_ranks = object.at("precursor_ranks");
  execution.precursor_ranks = precursor_ranks == 0 ? execution.ranks : precursor_ranks;
  execution.cores = object.at("cores");
  execution.walltime_seconds = optional_member<double>(object, "walltime_seconds");
  execution.max_failures_without_progress = object.at("max_failures_without_progress");
  if (execution.launcher == kSlurm) execution.slurm = slurm_from(object.at("slurm"));
  return execution;
}

void check_cores(const json& execution, std::vector<Mistake>& mistakes) {
  const int cores = execution.at("cores");
  for (const char* key : {"ranks", "precursor_ranks"})
    if (const int ranks = execution.at(key); cores > 0 && ranks > cores)
      mistakes.push_back({std::string("/execution/") + key, std::to_string(ranks),
                          "at most the " + counted(cores, "core") + " given"});
}

/// Ranks of a precursor are nobody's where there is none.
void check_precursor_ranks(const json& document, std::vector<Mistake>& mistakes) {
  const int ranks = document.at("execution").at("precursor_ranks");
  if (ranks > 0 && !document.contains("precursor"))
    mistakes.push_back({"/execution/precursor_ranks", std::to_string(ranks),
                        "has no effect: this campaign has no precursor, leave it out"});
}

/// Options of sbatch that softwall sets itself: by them it finds a job again, keeps its log and its attempts
/// in order, or has a key of its own.
constexpr std::array<std::string_view, 26> kOptionsOfOurs = {
    "--account",  "--array",     "--chdir",      "--clusters", "--dependency", "--error",     "--hold",
    "--input",    "--job-name",  "--no-requeue", "--nodes",    "--ntasks",     "--open-mode", "--output",
    "--parsable", "--partition", "--quiet",      "--requeue",  "--signal",     "--test-only", "--time",
    "--time-min", "--wait",      "--wrap",       "--help",     "--version"};

/// sbatch takes "--part" for "--partition", and none of its other options has such a beginning as its name.
bool is_ours(std::string_view option) {
  const auto name = option.substr(0, option.find('='));
  return std::ranges::any_of(kOptionsOfOurs, [&](std::string_view ours) { return ours.starts_with(name); });
}

void check_slurm_options(const json& options, std::vector<Mistake>& mistakes) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::string option = options[i];
    if (is_ours(option))
      mistakes.push_back({"/execution/slurm/options/" + std::to_string(i), quoted(options[i]),
                          "an option that softwall does not set itself, or has a key for"});
  }
}

/// Seconds that end an attempt, each earlier than the one after it: by its own clock, by the time limit.
void check_slurm_times(const json& execution, std::vector<Mistake>& mistakes) {
  const json& slurm = execution.at(kSlurm);
  if (!slurm.contains("time_limit_minutes")) return;
  const double limit = 60.0 * slurm.at("time_limit_minutes").get<int>();
  const std::string within = "less than the time limit, " + normalised_number(limit).dump() + " s";
  if (const int signal = slurm.at("signal_seconds"); signal >= limit)
    mistakes.push_back({"/execution/slurm/signal_seconds", std::to_string(signal), within});
  if (execution.contains("walltime_seconds") && execution.at("walltime_seconds").get<double>() >= limit)
    mistakes.push_back({"/execution/walltime_seconds", execution.at("walltime_seconds").dump(), within});
}

/// Several mpirun in one job know nothing of each other, and all begin to count at the first node.
void check_cases_per_job(const json& slurm, std::vector<Mistake>& mistakes) {
  if (slurm.at("cases_per_job").get<int>() == 1 || !slurm.contains("nodes") || slurm.at("nodes") == 1) return;
  mistakes.push_back({"/execution/slurm/nodes", slurm.at("nodes").dump(),
                      "1, or absent: cases that share a job share one node"});
}

void check_slurm(const json& execution, std::vector<Mistake>& mistakes) {
  if (!execution.contains(kSlurm)) return;
  if (execution.at("launcher") != kSlurm) {
    mistakes.push_back(
        {"/execution/slurm", quoted(execution.at(kSlurm)), "has no effect: the launcher is not slurm"});
    return;
  }
  check_slurm_options(execution.at(kSlurm).at("options"), mistakes);
  check_slurm_times(execution, mistakes);
  check_cases_per_job(execution.at(kSlurm), mistakes);
}

/// Jobs have defaults of their own also where nothing is asked of Slurm.
bool is_for_slurm(const json& document) {
  const auto execution = document.find("execution");
  return execution != document.end() && execution->is_object() &&
         execution->value("launcher", json()) == json(kSlurm);
}

/// Defaults of the campaign's own members; those of the physics belong to the case and are filled in there,
/// after the precursor's and the sweep's values have been put over the common ones.
json filled(const json& document) {
  json own = document;
  own.erase("physics");
  own.erase("precursor");
  own.erase("run");
  if (is_for_slurm(own) && !own["execution"].contains(kSlurm)) own["execution"][kSlurm] = json::object();
  campaign_schema().fill_defaults(own);
  for (const char* key : {"physics", "precursor", "run"})
    if (document.contains(key)) own[key] = document.at(key);
  return own;
}

/// True when no mistake found so far lies in one of these parts of the document.
bool sound(const std::vector<std::string>& parts, const std::vector<Mistake>& mistakes) {
  const auto lies_in = [](const std::string& where, const std::string& part) {
    return where == part || where.starts_with(part + "/");
  };
  return std::none_of(mistakes.begin(), mistakes.end(), [&](const Mistake& mistake) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const auto& part) { return lies_in(mistake.where, part); });
  });
}

/// What is derived need not be given, although every case needs it.
void forgive_what_is_derived(const json& derive, std::vector<Mistake>& mistakes) {
  for (const auto& [name, unused] : derive.items()) {
    const Parameter* parameter = find_parameter(name);
    if (!parameter) continue;
    const std::string where = "/physics" + parameter->pointer.to_string();
    std::erase_if(mistakes, [&](const Mistake& mistake) {
      return mistake.where == where && mistake.given == kMissing;
    });
  }
}

std::string flow_of(const json& document) {
  const json& standard = campaign_schema().part(json::json_pointer("/physics/flow"))->at("default");
  return document.at("physics").value("flow", standard.get<std::string>());
}

void add_cross_checks(const json& document, std::vector<Mistake>& mistakes) {
  if (sound({"/derive"}, mistakes)) forgive_what_is_derived(document.at("derive"), mistakes);
  if (sound({"/sweep"}, mistakes))
    for (auto& more : sweep_mistakes(document.at("sweep"))) mistakes.push_back(std::move(more));
  if (sound({"/derive", "/sweep", "/physics"}, mistakes)) {
    auto found = derive_mistakes(document.at("derive"), document.at("sweep"), document.at("physics"));
    for (auto& more : found) mistakes.push_back(std::move(more));
  }
  if (sound({"/until", "/physics"}, mistakes)) {
    for (auto& more : until_mistakes(document.at("until"), flow_of(document)))
      mistakes.push_back(std::move(more));
  }
  if (sound({"/start_from", "/until", "/physics"}, mistakes)) {
    auto found =
        start_from_mistakes(document.value("start_from", json()), document.at("until"), flow_of(document));
    for (auto& more : found) mistakes.push_back(std::move(more));
  }
  if (sound({"/execution"}, mistakes)) {
    check_cores(document.at("execution"), mistakes);
    check_precursor_ranks(document, mistakes);
    check_slurm(document.at("execution"), mistakes);
  }
}

CampaignSpec spec_of_cases(const json& document) {
  CampaignSpec spec;
  spec.physics = document.at("physics");
  spec.precursor = document.value("precursor", json());
  spec.sweep = document.at("sweep");
  spec.derive = document.at("derive");
  spec.start_from = start_from_of(document.value("start_from", json()));
  spec.run = document.at("run");
  return spec;
}

CampaignSpec spec_from(const json& document, const std::string& source, const std::string& text) {
  CampaignSpec spec = spec_of_cases(document);
  spec.name = document.at("name");
  spec.description = document.at("description");
  spec.until = interval_targets(document.at("until"));
  spec.execution = execution_from(document.at("execution"));
  spec.source = source;
  spec.text = text;
  return spec;
}

}  // namespace

const JsonSchema& campaign_schema() {
  static const JsonSchema schema(schemas::kCampaignSchema, {{"case.schema.json", schemas::kCaseSchema}});
  return schema;
}

CheckedSpec check_spec(const std::string& text, const std::string& source) {
  const json given = parse_json(text, source);
  CheckedSpec checked;
  checked.mistakes = campaign_schema().mistakes(given);
  if (!given.is_object()) return checked;
  const json document = filled(given);
  add_cross_checks(document, checked.mistakes);
  checked.can_expand = sound(
      {"/format", "/physics", "/precursor", "/sweep", "/derive", "/start_from", "/run"}, checked.mistakes);
  if (checked.mistakes.empty())
    checked.spec = spec_from(document, source, text);
  else if (checked.can_expand)
    checked.spec = spec_of_cases(document);
  return checked;
}

}  // namespace softwall::campaign
