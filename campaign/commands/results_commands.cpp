#include <iostream>
#include <sstream>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/store/query.hpp"
#include "campaign/store/sqlite.hpp"
#include "campaign/store/store.hpp"
#include "campaign/tables/paper_tables.hpp"
#include "solver/case/atomic_file.hpp"
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

}  // namespace

ExitStatus show_paper_tables(const std::filesystem::path& path) {
  write_paper_tables(std::cout, folder_with_store(path));
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
  const ResultTable results = export_results(folder_with_store(path));
  if (!file) {
    write_table(std::cout, results, table_format(format));
    return ExitStatus::kDone;
  }
  std::ostringstream text;
  write_table(text, results, table_format(format));
  write_atomically(*file, text.str());
  std::cerr << "Wrote " << results.rows.size() << " cases to " << file->string() << "\n";
  return ExitStatus::kDone;
}

}  // namespace softwall::campaign
