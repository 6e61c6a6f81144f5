#include <sqlite3.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <string_view>

#include "campaign/commands/command_line.hpp"
#include "campaign/commands/failure_report.hpp"
#include "campaign/runner/campaign_lock.hpp"
#include "campaign/store/sqlite.hpp"
#include "campaign/store/text_width.hpp"
#include "campaign/system/signals.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/spelling.hpp"
#include "solver/case/standard_streams.hpp"

/// softwall, the campaign manager: runs a command and tells what went wrong.
namespace softwall::campaign {
namespace {

/// Says what to do about a store that cannot be used. Only a damaged one is to be made again: on a full disk,
/// or while another program holds it, that would take away what is still good.
std::string advice_for(const SqliteError& error) {
  if (error.is_damage()) return "A damaged results store can be made again:  softwall rebuild PATH\n";
  switch (error.primary_code()) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "Another program holds the results store; end its transaction, then run the same command "
             "again.\n";
    case SQLITE_FULL:
      return "Make room on the disk, then run the same command again.\n";
    default:
      return "";
  }
}

/// A result that did not reach its reader was not delivered. What `run` has done, though, is done.
ExitStatus delivered(ExitStatus status, bool runs) {
  if (std::cout << std::flush) return status;
  std::cerr << "softwall: cannot write to standard output\n";
  return status == ExitStatus::kDone && !runs ? ExitStatus::kError : status;
}

/// Names the program, unless the message names a file of the user's first.
std::string told_by_program(const std::exception& error) {
  return "softwall: " + printable_lines(error.what()) + "\n";
}

ExitStatus run_reporting_errors(int count, char** words) {
  const bool runs =
      count > 1 && (std::string_view(words[1]) == "run" || std::string_view(words[1]) == "resume");
  const auto fail = [&](ExitStatus status, const std::string& text,
                        const std::vector<Mistake>& mistakes = {}) {
    report_failure(std::cerr, {status, text, mistakes}, wants_json(count, words));
    return status;
  };
  try {
    const ExitStatus status = run_command_line(count, words);
    return delivered(status, runs);
  } catch (const BadInput& error) {
    return fail(ExitStatus::kBadInput, printable_lines(error.what()) + "\n", error.mistakes);
  } catch (const CampaignOwned& error) {
    return fail(ExitStatus::kOwned, told_by_program(error));
  } catch (const SqliteError& error) {
    return fail(runs && error.may_pass() ? ExitStatus::kUnfinished : ExitStatus::kError,
                told_by_program(error) + advice_for(error));
  } catch (const std::exception& error) {
    return fail(ExitStatus::kError, told_by_program(error));
  }
}

}  // namespace
}  // namespace softwall::campaign

int main(int count, char** words) {
  softwall::open_standard_streams();
  softwall::campaign::begin_with_signals();
  return static_cast<int>(softwall::campaign::run_reporting_errors(count, words));
}
