#include <sqlite3.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string_view>

#include "campaign/commands/commands.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/store/sqlite.hpp"
#include "campaign/store/text_width.hpp"
#include "campaign/system/signals.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/option_number.hpp"
#include "solver/case/spelling.hpp"
#include "solver/case/standard_streams.hpp"
#include "solver/run_directory/build_info.hpp"

/// softwall: the command line of the campaign manager.
namespace softwall::campaign {
namespace {

constexpr double kLongestStallMinutes = 1e6;  // two years

/// What was given after the name of a command.
struct Arguments {
  std::filesystem::path path, file;
  std::string sql, chosen;
  bool json = false, csv = false, watch = false, remove = false;
  RunOptions run;
  [[nodiscard]] OutputFormat format() const {
    return json ? OutputFormat::kJson : csv ? OutputFormat::kCsv : OutputFormat::kText;
  }
};

using CommandAction = std::function<ExitStatus(const Arguments&)>;

class CommandLine {
 public:
  CommandLine();
  ExitStatus run(int count, char** words);

 private:
  CLI::App* add(const std::string& name, const std::string& help, CommandAction action);
  void add_results_commands();
  void suggest_command(int count, char** words) const;
  [[nodiscard]] std::string suggest_option(int count, char** words) const;

  CLI::App app_{"Campaigns of direct numerical simulations over elastic walls", "softwall"};
  Arguments arguments_;
  std::map<const CLI::App*, CommandAction> actions_;
};

CommandLine::CommandLine() {
  const BuildInfo build = build_info();
  app_.set_version_flag("--version", "softwall " + build.version + " (" + build.git_revision + ")");
  app_.require_subcommand(1);
  app_.footer(
      "PATH is a campaign file or its folder. Exit status: 0 all done, 1 error, 2 bad input,\n"
      "3 done with failed cases, 4 unfinished (resume), 5 another softwall runs the campaign.");
  const auto run = [](const Arguments& given) { return run_campaign(given.path, given.run); };
  for (CLI::App* command : {add("run", "Run a campaign to its end; what is finished is kept", run),
                            add("resume", "Go on with a campaign after any stop or crash", run)}) {
    command
        ->add_option("--stall-minutes", arguments_.run.stall_minutes,
                     "End an attempt that makes no step for this long")
        ->check(CLI::Validator(
            [](const std::string& text) {
              return trouble_with_number(text, {.low_allowed = false, .high = kLongestStallMinutes});
            },
            ""))
        ->capture_default_str();
    command->add_flag("--start-over", arguments_.run.start_over,
                      "Let cases that had checkpoints, of which none can be used, start from the beginning");
  }
  CLI::App* plan = add("plan", "Show what run would do, and what it would cost",
                       [](const Arguments& given) { return show_plan(given.path, given.json); });
  plan->add_flag("--json", arguments_.json, "Print one JSON value");
  CLI::App* status = add("status", "Show how far the cases are", [](const Arguments& given) {
    return given.watch ? watch_status(given.path) : show_status(given.path, given.json);
  });
  CLI::Option* json = status->add_flag("--json", arguments_.json, "Print one JSON value");
  status->add_flag("--watch", arguments_.watch, "Again every two seconds while the campaign runs")
      ->excludes(json);
  add_results_commands();
  CLI::App* verify =
      add("verify", "Read all checkpoints and records in full; change nothing", [](const Arguments& given) {
        return verify_campaign(given.path, given.chosen.empty() ? std::nullopt : std::optional(given.chosen));
      });
  verify->add_option("CASE", arguments_.chosen, "Label, or beginning of the id, of a single case");
  CLI::App* clean = add("clean", "List cases left over from earlier versions of the campaign file",
                        [](const Arguments& given) { return clean_campaign(given.path, given.remove); });
  clean->add_flag("--remove", arguments_.remove, "Remove them, with their run directories");
  add("rebuild", "Make the results store again from the run directories",
      [](const Arguments& given) { return rebuild_store(given.path); });
}

void CommandLine::add_results_commands() {
  add("table", "Print the paper's tables beside the measured values",
      [](const Arguments& given) { return show_paper_tables(given.path); });
  CLI::App* query = add("query", "Ask the results store in SQL (read only)", [](const Arguments& given) {
    return show_query(given.path, given.sql, given.format());
  });
  query->add_option("SQL", arguments_.sql, "One statement, e.g. \"SELECT label, re_tau FROM results\"")
      ->required();
  CLI::App* exporting = add("export", "Write one row a case", [](const Arguments& given) {
    return export_campaign(given.path, given.format(),
                           given.file.empty() ? std::nullopt : std::optional(given.file));
  });
  exporting->add_option("-o,--output", arguments_.file, "File to write instead of standard output");
  for (CLI::App* command : {query, exporting}) {
    CLI::Option_group* format = command->add_option_group("Format");
    format->add_flag("--csv", arguments_.csv, "Comma-separated values");
    format->add_flag("--json", arguments_.json, "Print one JSON value");
    format->require_option(command == exporting ? 1 : 0, 1);
  }
}

CLI::App* CommandLine::add(const std::string& name, const std::string& help, CommandAction action) {
  CLI::App* command = app_.add_subcommand(name, help);
  command->add_option("PATH", arguments_.path, "Campaign file or its folder")->required();
  actions_[command] = std::move(action);
  return command;
}

/// "softwall stauts": say which command was probably meant.
void CommandLine::suggest_command(int count, char** words) const {
  if (count < 2 || words[1][0] == '-') return;
  std::vector<std::string> known;
  for (const auto& [command, action] : actions_) known.push_back(command->get_name());
  if (std::ranges::find(known, words[1]) != known.end()) return;
  const auto near = suggestion(words[1], known);
  throw BadInput("softwall", {{"", "no command " + printable(words[1]),
                               near ? "did you mean " + *near + "?" : "softwall --help lists all commands"}});
}

/// "softwall plan --jsno DIR": the option that was probably meant.
std::string CommandLine::suggest_option(int count, char** words) const {
  const CLI::App* command = app_.get_subcommands().empty() ? &app_ : app_.get_subcommands().front();
  std::vector<std::string> known;
  for (const CLI::Option* option : command->get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (!word.starts_with("--") || std::ranges::find(known, word) != known.end()) continue;
    if (const auto near = suggestion(word, known)) return "Did you mean " + *near + "?\n";
  }
  return "";
}

ExitStatus CommandLine::run(int count, char** words) {
  if (count < 2) {
    std::cerr << app_.help();
    return ExitStatus::kBadInput;
  }
  suggest_command(count, words);
  try {
    app_.parse(count, words);
  } catch (const CLI::ExtrasError& error) {
    app_.exit(error, std::cout, std::cerr);
    std::cerr << suggest_option(count, words);
    return ExitStatus::kBadInput;
  } catch (const CLI::ParseError& error) {
    // Help and version are no errors; they go to standard output with status 0.
    return app_.exit(error, std::cout, std::cerr) == 0 ? ExitStatus::kDone : ExitStatus::kBadInput;
  }
  return actions_.at(app_.get_subcommands().front())(arguments_);
}

/// What is to be done about a store that cannot be used. Made again is only what is damaged: on a full disk,
/// or while another program holds it, that would take away what is still good.
std::string advice_for(const SqliteError& error) {
  switch (error.primary_code()) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "Another program holds the results store; end its transaction, then run the same command "
             "again.\n";
    case SQLITE_FULL:
      return "Make room on the disk, then run the same command again.\n";
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return "A damaged results store can be made again:  softwall rebuild PATH\n";
    default:
      return "";
  }
}

/// A result that did not reach its reader was not delivered. What `run` has done, though, is done.
ExitStatus delivered(ExitStatus status) {
  if (std::cout << std::flush) return status;
  std::cerr << "softwall: cannot write to standard output\n";
  return status == ExitStatus::kDone ? ExitStatus::kError : status;
}

ExitStatus run_reporting_errors(int count, char** words) {
  const bool runs =
      count > 1 && (std::string_view(words[1]) == "run" || std::string_view(words[1]) == "resume");
  try {
    const ExitStatus status = CommandLine().run(count, words);
    return runs ? status : delivered(status);
  } catch (const BadInput& error) {
    std::cerr << printable_lines(error.what()) << "\n";
    return ExitStatus::kBadInput;
  } catch (const CampaignOwned& error) {
    std::cerr << "softwall: " << printable_lines(error.what()) << "\n";
    return ExitStatus::kOwned;
  } catch (const SqliteError& error) {
    std::cerr << "softwall: " << printable_lines(error.what()) << "\n" << advice_for(error);
    return runs && error.may_pass() ? ExitStatus::kUnfinished : ExitStatus::kError;
  } catch (const std::exception& error) {
    std::cerr << "softwall: " << printable_lines(error.what()) << "\n";
    return ExitStatus::kError;
  }
}

}  // namespace
}  // namespace softwall::campaign

int main(int count, char** words) {
  softwall::open_standard_streams();
  softwall::campaign::expect_children();
  return static_cast<int>(softwall::campaign::run_reporting_errors(count, words));
}
