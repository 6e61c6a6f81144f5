#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "solver/case/case.hpp"
#include "solver/output/checkpoint_reader.hpp"
#include "solver/run_directory/report_file.hpp"
#include "solver/run_directory/run_record.hpp"
#include "solver/run_directory/statistics_file.hpp"
#include "solver/run_directory/status.hpp"
#include "solver/run_directory/summary.hpp"

/// Prints, as JSON, what the readers of this build find in the run directories of a campaign: of every file
/// some numbers that only the whole file, read rightly, can give.
namespace softwall {
namespace {

using nlohmann::json;

template <class Report>
json report_in(const std::filesystem::path& file, const std::string& id) {
  const auto report = read_report<Report>(file, id);
  if (!report) throw std::runtime_error(file.string() + " cannot be read");
  return *report;
}

/// Sum of n times the n-th value: a value in another place gives another sum.
double weighted_sum(const std::vector<double>& values) {
  double sum = 0, n = 0;
  for (const double value : values) sum += ++n * value;
  return sum;
}

json statistics_in(const std::filesystem::path& file) {
  const analysis::BlockStatistics s = analysis::read_statistics(file);
  json found = {{"case_id", s.case_id},
                {"reynolds", s.reynolds},
                {"elastic", s.elastic},
                {"interface_y", s.interface_y},
                {"blocks", s.blocks()},
                {"y_center", weighted_sum(s.y_center)},
                {"y_face", weighted_sum(s.y_face)},
                {"weight", weighted_sum(s.weight)}};
  for (const auto& [name, profile] : s.profiles) found["profiles"][name] = weighted_sum(profile.values);
  for (const auto& [name, values] : s.series) found["series"][name] = weighted_sum(values);
  return found;
}

json checkpoint_in(const std::filesystem::path& file, const std::string& id) {
  const CheckpointVerdict verdict = verify_checkpoint(file, id);
  if (!verdict.valid) throw std::runtime_error(file.string() + ": " + verdict.reason);
  const CheckpointHeader& header = verdict.header;
  const output::CheckpointFile checkpoint(file);
  json found = {{"step", header.step},           {"time", header.time},
                {"precision", header.precision}, {"grid", header.grid},
                {"length", header.length},       {"attempt", header.attempt},
                {"ranks", header.ranks},         {"y_face", weighted_sum(checkpoint.values("grid/y_face"))}};
  for (const char* const name : {"u", "v", "w", "p"}) {
    const std::string field = std::string("fields/") + name;
    const auto [nz, rows, nx] = checkpoint.extents(field);
    found[field] = {{"rows", rows}, {"sum", weighted_sum(checkpoint.columns(field, {0, nx, 0, nz}))}};
  }
  for (const auto& [name, sums] : checkpoint.more_statistics())
    found["statistics"][name] = weighted_sum(sums);
  return found;
}

json run_directory_in(const std::filesystem::path& folder) {
  const Case c = read_case(folder / "case.json");
  const RunFiles files(folder);
  json found = {{"case", to_json(c)},
                {"id", c.id},
                {"status", report_in<Status>(folder / "status.json", c.id)},
                {"summary", report_in<Summary>(folder / "summary.json", c.id)},
                {"run", report_in<softwall::RunRecord>(folder / "run.json", c.id)},
                {"statistics", statistics_in(folder / "statistics.h5")}};
  for (const auto& file : checkpoint_ladder(files))
    found["checkpoints"][file.filename().string()] = checkpoint_in(file, c.id);
  return found;
}

}  // namespace
}  // namespace softwall

int main(int count, char** arguments) {
  try {
    nlohmann::json found = nlohmann::json::object();
    for (int n = 1; n < count; ++n) {
      const std::filesystem::path folder(arguments[n]);
      found[folder.filename().string()] = softwall::run_directory_in(folder);
    }
    std::printf("%s\n", found.dump(1).c_str());
    return found.empty() ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
