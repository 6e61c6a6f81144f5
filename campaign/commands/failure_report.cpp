#include "campaign/commands/failure_report.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

namespace softwall::campaign {

nlohmann::ordered_json json_of_mistakes(const std::vector<Mistake>& mistakes) {
  auto all = nlohmann::ordered_json::array();
  for (const Mistake& one : mistakes)
    all.push_back({{"where", one.where}, {"given", one.given}, {"allowed", one.allowed}});
  return all;
}

void report_failure(std::ostream& out, const FailureReport& report, bool json) {
  if (!json) {
    out << report.text;
    return;
  }
  const auto end = report.text.find_last_not_of('\n');
  const nlohmann::ordered_json error = {{"status", static_cast<int>(report.status)},
                                        {"message", report.text.substr(0, end + 1)},
                                        {"mistakes", json_of_mistakes(report.mistakes)}};
  out << nlohmann::ordered_json{{"error", error}}.dump(2, ' ', false,
                                                       nlohmann::json::error_handler_t::replace)
      << "\n";
}

}  // namespace softwall::campaign
