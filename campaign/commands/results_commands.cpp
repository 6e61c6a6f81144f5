#include <algorithm>
#include <array>
#include <iostream>
#include <sstream>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/store/output_file.hpp"
#include "campaign/store/query.hpp"
#include "campaign/store/sqlite.hpp"
#include "campaign/store/store.hpp"
#include "campaign/tables/paper_tables.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

TableFormat table_format(OutputFormat format) {
  switch (format) {
    case OutputFormat::kCsv:
      return TableFormat::kCsv;
    case OutputFormat::kJson:
      return TableFormat::kJson;
    case OutputFormat::kText:
      break;
  }
  return TableFormat::kText;
}

/// An export must not take the place of what it was made from.
void refuse_own_files(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const auto target = std::filesystem::weakly_canonical(file);
  const auto inside = target.lexically_relative(std::filesystem::weakly_canonical(folder));
  constexpr std::array<std::string_view, 6> kOwn = {"results.db",    "results.db-wal", "results.db-shm",
                                                    "campaign.json", "campaign.lock",  "manager.log"};
  const bool own = std::ranges::find(kOwn, inside.string()) != kOwn.end() || *inside.begin() == "cases";
  if (own)
    throw BadInput("export", {{"", file.string() + " belongs to the campaign itself", "another file"}});
}

void tell_left_out(const std::filesystem::path& folder) {
  const std::int64_t cases = left_out(folder);
  if (cases == 0) return;
  std::cerr << "Left out: " << cases << (cases == 1 ? " case" : " cases")
            << " of earlier versions of the campaign file; the view results_all has them.\n";
}

}  // namespace

ExitStatus show_paper_tables(const std::filesystem::path& path) {
  const auto folder = folder_with_store(path);
  write_paper_tables(std::cout, folder);
  tell_left_out(folder);
  return ExitStatus::kDone;
}

ExitStatus show_query(const std::filesystem::path& path, const std::string& sql, OutputFormat format) {
  const auto folder = folder_with_store(path);
  static_cast<void>(Store::open(folder, OpenMode::kReadOnly));  // so that what follows is the query's fault
  try {
    write_table(std::cout, run_query(folder, sql), table_format(format));
  } catch (const SqliteError& error) {
    throw BadInput("query", {{"", error.what(), "one SQL statement that reads"}});
  }
  return ExitStatus::kDone;
}

ExitStatus export_campaign(const std::filesystem::path& path, OutputFormat format,
                           const std::optional<std::filesystem::path>& file) {
  const auto folder = folder_with_store(path);
  const ResultTable results = export_results(folder);
  tell_left_out(folder);
  if (!file) {
    write_table(std::cout, results, table_format(format));
    return ExitStatus::kDone;
  }
  refuse_own_files(*file, folder);
  std::ostringstream text;
  write_table(text, results, table_format(format));
  write_output(*file, text.str());
  std::cerr << "Wrote " << results.rows.size() << " cases to " << file->string() << "\n";
  return ExitStatus::kDone;
}

}  // namespace softwall::campaign
