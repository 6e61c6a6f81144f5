#include "campaign/runner/runner_report.hpp"

#include "campaign/core/plan.hpp"

namespace softwall::campaign {

namespace {

/// The first of the case, the one that it starts from, the one that this starts from, ... of which something
/// is true; null where it is true of none.
template <class Holds>
const CampaignCase* first_in_line(const CaseBook& book, const CampaignCase& one, const Holds& holds) {
  const CampaignCase* at = &one;
  while (!holds(*at)) {
    if (at->precursor_id.empty()) return nullptr;
    at = &book.find(at->precursor_id);
  }
  return at;
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
    const auto paused = [&](const CampaignCase& each) { return book.paused().contains(each.definition.id); };
    const auto needs_person = [&](const CampaignCase& each) { return !book.seen(each).needs_person.empty(); };
    if (without_result.contains(decision.case_id)) {
      report.failed.push_back({label, without_result.at(decision.case_id), one.directory});
    } else if (decision.outlook == Outlook::kKept) {
      ++report.finished;
    } else if (paused(one)) {
      report.unfinished.push_back({label, book.paused().at(decision.case_id), one.directory});
    } else if (const CampaignCase* before = first_in_line(book, one, paused)) {
      report.unfinished.push_back(
          {label, "waits for " + before->definition.label + ", which is paused", one.directory});
    } else if (decision.outlook == Outlook::kBlocked && first_in_line(book, one, needs_person)) {
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
