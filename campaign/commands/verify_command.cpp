#include <array>
#include <iostream>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_reports.hpp"
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

/// Counts what was looked at and tells what is wrong.
struct Findings {
  int checked = 0;
  int wrong = 0;
  void add(const std::string& what, const std::string& trouble) {
    ++checked;
    if (trouble.empty()) return;
    ++wrong;
    std::cout << "BAD  " << what << ": " << trouble << "\n";
  }
};

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

void verify_case(const CampaignCase& one, const RunFiles& run, Findings& findings) {
  const std::string& id = one.definition.id;
  const auto name_of = [&](const std::filesystem::path& file) {
    return one.directory + "/" + file.lexically_relative(run.directory).string();
  };
  for (const auto& file : checkpoint_ladder(run)) {
    const CheckpointVerdict verdict = verify_checkpoint(file, id);
    findings.add(name_of(file), verdict.valid ? "" : verdict.reason);
  }
  if (std::filesystem::exists(run.summary())) {
    findings.add(name_of(run.summary()), read_summary(run, id)
                                             ? trouble_with_json(run.summary(), schemas::kSummarySchema)
                                             : "cannot be read, or is not of case " + id);
  }
  const std::array<std::pair<std::filesystem::path, std::string_view>, 3> others = {
      {{run.case_file(), schemas::kCaseSchema},
       {run.run_record(), schemas::kRunSchema},
       {run.status(), schemas::kStatusSchema}}};
  for (const auto& [file, schema] : others) {
    if (std::filesystem::exists(file)) findings.add(name_of(file), trouble_with_json(file, schema));
  }
  const Observation seen = observe_files(one, run);
  if (seen.state != CaseState::kFinished) return;
  findings.add(name_of(run.checkpoints()),
               seen.newest_checkpoint ? "" : "a finished case without a checkpoint");
  findings.add(name_of(run.statistics()), trouble_with_statistics(run, id));
}

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
  throw BadInput(campaign.name, {{"", "no case " + printable(*chosen),
                                  near ? "perhaps " + *near : "a label, or the beginning of a case id"}});
}

}  // namespace

ExitStatus verify_campaign(const std::filesystem::path& path, const std::optional<std::string>& chosen) {
  const LoadedCampaign loaded = load_campaign(path);
  Findings findings;
  for (const CampaignCase* one : choose(loaded.campaign, chosen)) {
    verify_case(*one, run_files(loaded.folder, *one), findings);
  }
  std::cout << findings.checked << " files checked, " << findings.wrong << " bad." << std::endl;
  return findings.wrong == 0 ? ExitStatus::kDone : ExitStatus::kFailedCases;
}

}  // namespace softwall::campaign
