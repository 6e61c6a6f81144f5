/// Leaves what softwall-dns leaves at the end of a case, without computing anything, so that what the manager
/// itself costs can be measured.
///   stub_solver RUN_DIR --attempt N ...   one case, in the solver's place
///   stub_solver --many                    many: lines "CASE_ID END_TIME RUN_DIR" from standard input
#include <cstring>
#include <iostream>

#include "solver/case/case.hpp"
#include "solver/run_directory/statistics_file.hpp"
#include "tests/analysis/samples.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"

namespace softwall {
namespace {

/// Writes statistics of this case up to its end; with an empty id they belong to no particular case, so that
/// one file serves all.
void write_statistics_of(const std::string& case_id, double end_time, const std::filesystem::path& file) {
  constexpr int kBlocks = 10;
  auto statistics = analysis::samples::elastic_statistics({}, kBlocks);
  statistics.case_id = case_id;
  analysis::samples::set_blocks(statistics, kBlocks, end_time / 2, end_time / 2 / kBlocks);
  analysis::write_statistics(file, statistics);
}

void finish_one(const std::filesystem::path& directory, int attempt) {
  const RunFiles run{directory};
  const Case one = read_case(run.case_file());
  write_statistics_of(one.id, one.run.end_time, run.statistics());
  test::write_summary(run, one.id, attempt, "finished", 1000, one.run.end_time);
}

void finish_many(std::istream& in) {
  std::filesystem::path first;
  std::string id, directory;
  double end_time = 0;
  while (in >> id >> end_time >> directory) {
    const RunFiles run{directory};
    std::filesystem::create_directories(run.directory);
    if (first.empty())
      write_statistics_of("", end_time, first = run.statistics());
    else
      std::filesystem::copy_file(first, run.statistics());
    test::write_summary(run, id, 1, "finished", 1000, end_time);
  }
}

}  // namespace
}  // namespace softwall

int main(int count, char** words) {
  if (count == 2 && std::strcmp(words[1], "--many") == 0) {
    softwall::finish_many(std::cin);
    return 0;
  }
  if (count < 4 || std::strcmp(words[2], "--attempt") != 0) return 2;
  softwall::finish_one(words[1], std::stoi(words[3]));
  return 0;
}
