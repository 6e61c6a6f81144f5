#include "campaign/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <string_view>

#include "campaign/commands/arguments.hpp"
#include "campaign/commands/command_help.hpp"
#include "campaign/commands/command_options.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/completion.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/option_number.hpp"
#include "solver/case/spelling.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {
namespace {

constexpr double kLongestStallMinutes = 1e6;  // two years
constexpr double kLatestWindowStart = 1e9;    // as statistics.start_time of a campaign, h/U_b

/// Refuses the text of an option that is no number of this range.
CLI::Validator number_check(const OptionRange& range) {
  return {[range](const std::string& text) { return trouble_with_number(text, range); }, ""};
}

using CommandAction = std::function<ExitStatus(const Arguments&)>;

class CommandLine {
 public:
  CommandLine();
  ExitStatus run(int count, char** words);

 private:
  CLI::App* add(const std::string& name, const std::string& help, CommandAction action);
  void add_init();
  void add_run();
  void add_status();
  void add_tables();
  void add_figures();
  void add_report();
  void add_upkeep();
  void add_completion();
  void add_from(CLI::App& command);
  [[nodiscard]] std::vector<std::string> command_names() const;
  [[nodiscard]] bool asks_for_help(int count, char** words) const;
  void print_help(const std::string& command) const;
  [[nodiscard]] std::string suggest_option(int count, char** words) const;

  CLI::App app_{"Campaigns of direct numerical simulations over elastic walls", "softwall"};
  Arguments arguments_;
  std::map<const CLI::App*, CommandAction> actions_;
};

CommandLine::CommandLine() {
  const BuildInfo build = build_info();
  app_.set_version_flag("--version", "softwall " + build.version + " (" + build.git_revision + ")");
  app_.require_subcommand(1);
  app_.formatter(help_with_examples());
  app_.footer(
      "PATH is a campaign file or its folder. Exit status: 0 all done, 1 error, 2 bad input,\n"
      "3 done with failed cases, 4 unfinished (resume), 5 another softwall runs the campaign.");
  add_init();
  add_run();
  add_status();
  add_tables();
  add_figures();
  add_report();
  add_upkeep();
  add_completion();
  app_.add_subcommand("help", "Explain softwall, or the command named behind it")
      ->add_option("COMMAND", arguments_.chosen, "A command");
}

void CommandLine::add_init() {
  CLI::App* init = add("init", "Write a first campaign file, and explain its keys",
                       [](const Arguments& given) { return begin_campaign(given.path); });
  init->get_option("PATH")->description("A new folder for the campaign, or one without a campaign file");
}

void CommandLine::add_run() {
  const auto run = [](const Arguments& given) { return run_campaign(given.path, given.run); };
  for (CLI::App* command : {add("run", "Run a campaign to its end; what is finished is kept", run),
                            add("resume", "Go on with a campaign after any stop or crash", run)}) {
    command
        ->add_option("--stall-minutes", arguments_.run.stall_minutes,
                     "End an attempt that makes no step for this long")
        ->check(number_check({.low_allowed = false, .high = kLongestStallMinutes}))
        ->capture_default_str();
    command->add_flag("--start-over", arguments_.run.start_over,
                      "Let cases that had checkpoints, of which none can be used, start from the beginning");
  }
}

/// What would be, and what is.
void CommandLine::add_status() {
  add("plan", "Show what run would do, and what it would cost", [](const Arguments& given) {
    return show_plan(given.path, given.json);
  })->add_flag("--json", arguments_.json, "Print one JSON value");
  CLI::App* status = add("status", "Show how far the cases are", [](const Arguments& given) {
    const StatusOptions options{given.json, given.why};
    return given.watch ? watch_status(given.path, options) : show_status(given.path, options);
  });
  CLI::Option* json = status->add_flag("--json", arguments_.json, "Print one JSON value");
  status
      ->add_flag("--watch", arguments_.watch,
                 "Again every two seconds, as much as the window holds, until the run ends; waits for one")
      ->excludes(json);
  status->add_flag("--why", arguments_.why, "Say what would become of each case now, and for what reason");
}

/// Results as text: tables, answers, rows.
void CommandLine::add_tables() {
  CLI::App* table =
      add("table", "Print the paper's tables beside the measured values",
          [](const Arguments& given) { return show_paper_tables(given.results(), given.format()); });
  CLI::App* query = add("query", "Ask the results store in SQL (read only)", [](const Arguments& given) {
    return show_query(given.results(), given.sql, given.format());
  });
  query->add_option("SQL", arguments_.sql, "One statement, e.g. \"SELECT label, re_tau FROM results\"")
      ->required();
  CLI::App* exporting = add("export", "Write one row a case", [](const Arguments& given) {
    return export_campaign(given.results(), given.format(), given.output());
  });
  exporting->add_option("-o,--output", arguments_.file, "File to write instead of standard output");
  for (CLI::App* command : {table, query, exporting}) {
    add_from(*command);
    CLI::Option_group* format = command->add_option_group("Format");
    format->add_flag("--csv", arguments_.csv, "Comma-separated values");
    format->add_flag("--json", arguments_.json, "Print one JSON value");
    if (command == query)
      format->add_flag("--vertical", arguments_.vertical, "One value a line, for rows of many columns");
    if (command == table) format->add_flag("--latex", arguments_.latex, "Two tabulars for each reading of G");
    format->require_option(command == exporting ? 1 : 0, 1);
  }
}

void CommandLine::add_figures() {
  CLI::App* figures =
      add("figures", "Draw every figure that the campaign's data allow",
          [](const Arguments& given) -> ExitStatus {
            draw_figures(given.results(), {given.output(), given.picture, given.style, !given.no_caption});
          });
  figures->add_option("-o,--output", arguments_.file,
                      "Folder to write to; default: figures/ in the campaign's");
  figures->add_option("--format", arguments_.picture, "Format of the pictures")
      ->check(CLI::IsMember({"png", "pdf", "svg"}))
      ->capture_default_str();
  figures
      ->add_option("--style", arguments_.style,
                   "What they are for: journal has serifs and 300 dots an inch, talk large letters")
      ->check(CLI::IsMember({"screen", "journal", "talk"}))
      ->capture_default_str();
  figures->add_flag("--no-caption", arguments_.no_caption, "Leave out the lines below each figure");
  add_from(*figures);
}

void CommandLine::add_report() {
  CLI::App* report = add("report", "Write one HTML page: cases, tables, figures, provenance",
                         [](const Arguments& given) -> ExitStatus {
                           write_report(given.results(), {given.output(), given.watch});
                         });
  report->add_option("-o,--output", arguments_.file,
                     "File to write; default: report.html in the campaign's folder");
  report->add_flag("--watch", arguments_.watch, "Write it again every minute until the run has ended");
  add_from(*report);
}

void CommandLine::add_from(CLI::App& command) {
  command
      .add_option("--from", arguments_.from,
                  "Begin the averages at this time [h/U_b], but those of precursors; changes nothing on disk")
      ->check(number_check({.low_allowed = true, .high = kLatestWindowStart}));
}

/// What keeps a campaign's folder in order.
void CommandLine::add_upkeep() {
  add("verify", "Read all checkpoints and records in full; change nothing", [](const Arguments& given) {
    return verify_campaign(given.path, given.chosen.empty() ? std::nullopt : std::optional(given.chosen));
  })->add_option("CASE", arguments_.chosen, "Label, or beginning of the id, of a single case");
  add("clean", "List cases left over from earlier versions of the campaign file", [](const Arguments& given) {
    return clean_campaign(given.path, given.remove);
  })->add_flag("--remove", arguments_.remove, "Remove them, with their run directories");
  add("rebuild", "Make the results store again from the run directories",
      [](const Arguments& given) { return rebuild_store(given.path); });
}

void CommandLine::add_completion() {
  CLI::App* completion =
      app_.add_subcommand("completion", "Print a script by which a shell completes commands and options");
  completion->add_option("SHELL", arguments_.shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  actions_[completion] = [this](const Arguments& given) {
    const Shell shell = given.shell == "bash"  ? Shell::kBash
                        : given.shell == "zsh" ? Shell::kZsh
                                               : Shell::kFish;
    std::cout << completion_script(shell, words_of_commands(app_));
    return ExitStatus::kDone;
  };
}

CLI::App* CommandLine::add(const std::string& name, const std::string& help, CommandAction action) {
  CLI::App* command = app_.add_subcommand(name, help);
  command->add_option("PATH", arguments_.path, "Campaign file or its folder")->required();
  actions_[command] = std::move(action);
  return command;
}

/// Of softwall, "help" among them.
std::vector<std::string> CommandLine::command_names() const {
  std::vector<std::string> known{"help"};
  for (const auto& [command, action] : actions_) known.push_back(command->get_name());
  return known;
}

/// "softwall help" and "softwall help run"; "softwall help --help" is read like any other command.
bool CommandLine::asks_for_help(int count, char** words) const {
  return std::string_view(words[1]) == "help" && (count == 2 || words[2][0] != '-');
}

void CommandLine::print_help(const std::string& command) const {
  if (command.empty()) {
    std::cout << app_.help();
    return;
  }
  for (const auto& [known, action] : actions_) {
    if (known->get_name() == command) {
      std::cout << known->help("softwall");
      return;
    }
  }
  throw BadInput("softwall help",
                 {{"", "no command " + printable_excerpt(command), "softwall help lists all commands"}});
}

std::string CommandLine::suggest_option(int count, char** words) const {
  const CLI::App* command = app_.get_subcommands().empty() ? &app_ : app_.get_subcommands().front();
  return option_probably_meant({words, words + count}, *command);
}

ExitStatus CommandLine::run(int count, char** words) {
  if (count < 2) {
    std::cerr << app_.help();
    return ExitStatus::kBadInput;
  }
  if (words[1][0] != '-') refuse_unknown_command(words[1], command_names());
  if (asks_for_help(count, words)) {
    print_help(count == 2 ? "" : words[2]);
    return ExitStatus::kDone;
  }
  try {
    app_.parse(count, words);
  } catch (const CLI::Success& asked) {
    return app_.exit(asked, std::cout, std::cerr) == 0 ? ExitStatus::kDone : ExitStatus::kBadInput;
  } catch (const CLI::ParseError& error) {
    if (wants_json(count, words))
      throw BadInput("softwall", {{"", error.what(), suggest_option(count, words)}});
    app_.exit(error, std::cout, std::cerr);
    if (const std::string near = suggest_option(count, words); !near.empty()) std::cerr << near << "\n";
    return ExitStatus::kBadInput;
  }
  return actions_.at(app_.get_subcommands().front())(arguments_);
}

}  // namespace

bool wants_json(int count, char** words) {
  return std::any_of(words, words + count, [](std::string_view word) { return word == "--json"; });
}

ExitStatus run_command_line(int count, char** words) { return CommandLine().run(count, words); }

}  // namespace softwall::campaign
