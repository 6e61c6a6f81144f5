#include "campaign/core/spec.hpp"

#include <algorithm>

#include "campaign/core/sweep.hpp"
#include "campaign/core/words.hpp"
#include "schemas/embedded.hpp"
#include "solver/case/json_text.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

Execution execution_from(const json& object) {
  Execution execution;
  execution.launcher = object.at("launcher");
  execution.ranks = object.at("ranks");
  const int precursor_ranks = object.at("precursor_ranks");
  execution.precursor_ranks = precursor_ranks == 0 ? execution.ranks : precursor_ranks;
  execution.cores = object.at("cores");
  if (object.contains("walltime_seconds"))
    execution.walltime_seconds = object.at("walltime_seconds").get<double>();
  execution.max_failures_without_progress = object.at("max_failures_without_progress");
  return execution;
}

void check_cores(const json& execution, std::vector<Mistake>& mistakes) {
  const int cores = execution.at("cores");
  for (const char* key : {"ranks", "precursor_ranks"})
    if (const int ranks = execution.at(key); cores > 0 && ranks > cores)
      mistakes.push_back({std::string("/execution/") + key, std::to_string(ranks),
                          "execution.cores gives " + counted(cores, "core")});
}

/// Ranks of a precursor are nobody's where there is none.
void check_precursor_ranks(const json& document, std::vector<Mistake>& mistakes) {
  const int ranks = document.at("execution").at("precursor_ranks");
  if (ranks > 0 && !document.contains("precursor"))
    mistakes.push_back({"/execution/precursor_ranks", std::to_string(ranks),
                        "has no effect: this campaign has no precursor, leave it out"});
}

/// Defaults of the campaign's own members; those of the physics belong to the case and are filled in there,
/// after the precursor's and the sweep's values have been put over the common ones.
json filled(const json& document) {
  json own = document;
  own.erase("physics");
  own.erase("precursor");
  own.erase("run");
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

void add_cross_checks(const json& document, std::vector<Mistake>& mistakes) {
  if (sound({"/sweep"}, mistakes))
    for (auto& more : sweep_mistakes(document.at("sweep"))) mistakes.push_back(std::move(more));
  if (sound({"/execution"}, mistakes)) {
    check_cores(document.at("execution"), mistakes);
    check_precursor_ranks(document, mistakes);
  }
}

CampaignSpec spec_of_cases(const json& document) {
  CampaignSpec spec;
  spec.physics = document.at("physics");
  spec.precursor = document.value("precursor", json());
  spec.sweep = document.at("sweep");
  spec.run = document.at("run");
  return spec;
}

CampaignSpec spec_from(const json& document, const std::string& source, const std::string& text) {
  CampaignSpec spec = spec_of_cases(document);
  spec.name = document.at("name");
  spec.description = document.at("description");
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
  checked.can_expand = sound({"/format", "/physics", "/precursor", "/sweep", "/run"}, checked.mistakes);
  if (checked.mistakes.empty())
    checked.spec = spec_from(document, source, text);
  else if (checked.can_expand)
    checked.spec = spec_of_cases(document);
  return checked;
}

}  // namespace softwall::campaign
