#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

/// The small JSON files of a run directory: status.json, summary.json and run.json. A file that is missing,
/// not complete or of another case counts as absent: it proves nothing.
namespace softwall {

inline constexpr int kReportFormat = 1;  ///< member "format" of each

/// A member that is a number, or else 0: what is not finite is written as null.
[[nodiscard]] inline double number_in(const nlohmann::json& object, const char* name) {
  const auto member = object.find(name);
  return member != object.end() && member->is_number() ? member->get<double>() : 0.0;
}

/// The report in a file, when it is complete, of this format and, where a case is named, of that case.
template <class Report>
[[nodiscard]] std::optional<Report> read_report(const std::filesystem::path& file,
                                                const std::string& case_id = "") {
  std::ifstream in(file);
  if (!in) return std::nullopt;
  const auto object = nlohmann::json::parse(in, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  try {
    if (object.at("format") != kReportFormat) return std::nullopt;
    if (!case_id.empty() && object.at("case_id") != case_id) return std::nullopt;
    return object.get<Report>();
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // members of a wrong type make the whole report worthless
  }
}

}  // namespace softwall
