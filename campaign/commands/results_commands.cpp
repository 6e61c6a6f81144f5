#include <iostream>
#include <sstream>

#include "campaign/commands/as_last_run.hpp"
#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/own_files.hpp"
#include "campaign/core/words.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/store/output_file.hpp"
#include "campaign/store/query.hpp"
#include "campaign/store/sqlite.hpp"
#include "campaign/store/store.hpp"
#include "campaign/store/text_width.hpp"
#include "campaign/store/windowed_results.hpp"
#include "campaign/system/shell_words.hpp"
#include "campaign/tables/comparison_rows.hpp"
#include "campaign/tables/latex_tables.hpp"
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
    case OutputFormat::kVertical:
      return TableFormat::kVertical;
    case OutputFormat::kText:
    case OutputFormat::kLatex:
      break;
  }
  return TableFormat::kText;
}

void tell_left_out(Connection& store) {
  const std::int64_t cases = left_out(store);
  if (cases == 0) return;
  std::cerr << "Left out: " << counted(cases, "case")
            << " of earlier versions of the campaign file; the view results_all has them.\n";
}

/// Nobody brings the store up to date any more, and it does not tell by itself.
void tell_if_left_at_work(const WantedResults& wanted, const std::filesystem::path& folder,
                          Connection& store) {
  const std::int64_t cases =
      store.integer("SELECT count(*) FROM cases WHERE state = 'running' AND in_campaign = 1");
  if (cases == 0 || living_owner(folder) || owner_is_unknown(folder)) return;
  std::cerr << counted(cases, "case") << (cases == 1 ? " was" : " were")
            << " running when softwall stopped, which these results are from; what has become of "
            << (cases == 1 ? "it" : "them") << ":  " << softwall_command("status", wanted.path) << "\n";
}

void tell_how_current(const WantedResults& wanted, const std::filesystem::path& folder, Connection& store) {
  tell_if_not_as_last_run(wanted.path, store);
  tell_if_left_at_work(wanted, folder, store);
}

Store results_of(const WantedResults& wanted) {
  const std::filesystem::path folder = folder_with_store(wanted.path);
  if (!wanted.from) {
    Store store = Store::open(folder, OpenMode::kReadOnly);
    tell_how_current(wanted, folder, store.connection());
    return store;
  }
  WindowedResults results = results_from(folder, *wanted.from);
  tell_how_current(wanted, folder, results.store.connection());
  for (const std::string& trouble : results.troubles)
    std::cerr << "No result from t = " << *wanted.from << ": " << printable_lines(trouble) << "\n";
  return std::move(results.store);
}

}  // namespace

ExitStatus show_paper_tables(const WantedResults& wanted, OutputFormat format) {
  Store store = results_of(wanted);
  if (format == OutputFormat::kText)
    write_paper_tables(std::cout, store.connection());
  else if (format == OutputFormat::kLatex)
    write_latex_tables(std::cout, store.connection());
  else
    write_table(std::cout, comparison_rows(store.connection()), table_format(format));
  tell_left_out(store.connection());
  return ExitStatus::kDone;
}

ExitStatus show_query(const WantedResults& wanted, const std::string& sql, OutputFormat format) {
  Store store = results_of(wanted);
  try {
    write_table(std::cout, run_query(store.connection(), sql), table_format(format));
  } catch (const SqliteError& error) {
    if (error.may_pass() || error.is_damage()) throw;  // no matter of what was asked
    throw BadInput("query", {{"", error.what(), advice_for_query(store.connection(), error.what())}});
  }
  return ExitStatus::kDone;
}

ExitStatus export_campaign(const WantedResults& wanted, OutputFormat format,
                           const std::optional<std::filesystem::path>& file) {
  Store store = results_of(wanted);
  const ResultTable results = export_results(store.connection());
  tell_left_out(store.connection());
  if (!file) {
    write_table(std::cout, results, table_format(format));
    return ExitStatus::kDone;
  }
  refuse_own_files("export", *file, wanted.path);
  std::ostringstream text;
  write_table(text, results, table_format(format));
  write_output(*file, text.str());
  std::cerr << "Wrote " << counted(std::ssize(results.rows), "case") << " to " << file->string() << "\n";
  return ExitStatus::kDone;
}

}  // namespace softwall::campaign
