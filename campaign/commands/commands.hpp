#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "campaign/commands/exit_status.hpp"
#include "campaign/core/campaign.hpp"

/// The commands of softwall, one file each. Results go to standard output, messages to standard error.
/// A path is a campaign file or its folder. All throw BadInput for what cannot be used.
namespace softwall::campaign {

/// Writes a small campaign file into this folder, which is made if it is not there, and explains its keys.
[[nodiscard]] ExitStatus begin_campaign(const std::filesystem::path& folder);

struct RunOptions {
  double stall_minutes = 30.0;  ///< an attempt without a step for this long is ended and tried again
  bool start_over =
      false;  ///< cases that had checkpoints, of which none can be used, start from the beginning
};
[[nodiscard]] ExitStatus run_campaign(const std::filesystem::path& path, const RunOptions& options);

[[nodiscard]] ExitStatus show_plan(const std::filesystem::path& path, bool json);

struct StatusOptions {
  bool json = false;
  bool why = false;  ///< also what would become of each case now, and for what reason
};
[[nodiscard]] ExitStatus show_status(const std::filesystem::path& path, const StatusOptions& options);
/// Again every two seconds, as many cases as the terminal has lines for, until the run that it saw has ended
/// or nothing is left to run; started before a run, it waits for one.
[[nodiscard]] ExitStatus watch_status(const std::filesystem::path& path, const StatusOptions& options);

/// Chooses results: those of the campaign at this path, as the store has them or with averages that begin
/// elsewhere.
struct WantedResults {
  std::filesystem::path path;
  std::optional<double> from;  ///< start of the averages of all cases but precursors, h/U_b
};
enum class OutputFormat { kText, kVertical, kCsv, kJson, kLatex };
[[nodiscard]] ExitStatus show_paper_tables(const WantedResults& wanted, OutputFormat format);
[[nodiscard]] ExitStatus show_query(const WantedResults& wanted, const std::string& sql, OutputFormat format);
/// To standard output where no file is named.
[[nodiscard]] ExitStatus export_campaign(const WantedResults& wanted, OutputFormat format,
                                         const std::optional<std::filesystem::path>& file);

struct FigureOptions {
  std::optional<std::filesystem::path> output;  ///< folder; figures/ in the campaign's where none is given
  std::string format = "png";                   ///< "png", "pdf" or "svg"
  std::string style = "screen";                 ///< "screen", "journal" or "talk"
  bool caption = true;                          ///< lines below each figure that say what it rests on
};
/// Every figure that the campaign's data allow. Python takes the place of this process.
[[noreturn]] void draw_figures(const WantedResults& wanted, const FigureOptions& options);

struct ReportOptions {
  std::optional<std::filesystem::path> output;  ///< report.html in the campaign's folder where none is given
  bool watch = false;                           ///< again every minute until the run has ended
};
/// One HTML page of the campaign, finished or not. Python takes the place of this process.
[[noreturn]] void write_report(const WantedResults& wanted, const ReportOptions& options);

/// Checkpoints, summaries and statistics of all cases, or of one (its label or the beginning of its id), read
/// in full. Changes nothing.
[[nodiscard]] ExitStatus verify_campaign(const std::filesystem::path& path,
                                         const std::optional<std::string>& chosen);
/// Lists the cases that are no longer part of the campaign; removes their run directories and what the store
/// knows of them only when that is asked for.
[[nodiscard]] ExitStatus clean_campaign(const std::filesystem::path& path, bool really);
[[nodiscard]] ExitStatus rebuild_store(const std::filesystem::path& path);

}  // namespace softwall::campaign
