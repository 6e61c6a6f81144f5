#include "campaign/runner/runner_report.hpp"

#include "campaign/core/plan.hpp"

namespace softwall::campaign {

namespace {

/// The case, or the one that it starts from.
bool needs_person(const CaseBook& book, const CampaignCase& one) {
  if (!book.seen(one).needs_person.empty()) return true;
  return !one.precursor_id.empty() && !book.seen(book.find(one.precursor_id)).needs_person.empty();
}

}  // namespace

RunnerReport make_report(const CaseBook& book, const std::map<std::string, std::string>& without_result,
                         bool stopped) {
  RunnerReport report;
  report.cases = book.campaign().cases.size();
  report.stopped = stopped;
  for (const Decision& decision : decide(book.campaign(), book.observations())) {
    const CampaignCase& one = book.find(decision.case_id);
    const std::string& label = one.definition.label;
    if (without_result.contains(decision.case_id)) {
      report.failed.push_back({label, without_result.at(decision.case_id), one.directory});
    } else if (decision.outlook == Outlook::kKept) {
      ++report.finished;
    } else if (book.paused().contains(decision.case_id)) {
      report.unfinished.push_back({label, book.paused().at(decision.case_id), one.directory});
    } else if (book.paused().contains(one.precursor_id)) {
      report.unfinished.push_back(
          {label, "waits for " + book.find(one.precursor_id).definition.label + ", which is paused",
           one.directory});
    } else if (decision.outlook == Outlook::kBlocked && needs_person(book, one)) {
      report.unfinished.push_back({label, decision.reason, one.directory});
    } else if (book.given_up().contains(decision.case_id)) {
      report.failed.push_back({label, book.given_up().at(decision.case_id), one.directory});
    } else if (decision.outlook == Outlook::kBlocked) {
      report.failed.push_back({label, decision.reason, one.directory});
    } else {
      const bool waits = decision.outlook == Outlook::kWaiting;
      report.unfinished.push_back({label, (waits ? "waits " : "") + decision.reason, one.directory});
    }
  }
  return report;
}

}  // namespace softwall::campaign
