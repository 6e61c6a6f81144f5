#include <unistd.h>

#include <array>
#include <cerrno>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "campaign/commands/as_last_run.hpp"
#include "campaign/commands/campaign_folder.hpp"
#include "campaign/commands/commands.hpp"
#include "campaign/commands/own_files.hpp"
#include "campaign/store/store.hpp"
#include "campaign/system/find_program.hpp"

/// Figures and reports are drawn by Python scripts (analysis/), which softwall finds and becomes.
namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

fs::path own_program() { return fs::read_symlink("/proc/self/exe"); }

/// Where it was installed beside this program, else in the sources this program was built from.
fs::path script(const std::string& name) {
  const std::array folders{own_program().parent_path().parent_path() / "share" / "softwall" / "analysis",
                           fs::path(SOFTWALL_ANALYSIS_FOLDER)};
  for (const fs::path& folder : folders) {
    std::error_code unreadable;
    if (fs::exists(folder / name, unreadable)) return folder / name;
  }
  throw std::runtime_error("the scripts that draw the figures are neither in " + folders[0].string() +
                           " nor in " + folders[1].string());
}

/// The system's own first: that is where Debian puts h5py and matplotlib.
fs::path python() {
  if (const fs::path usual = "/usr/bin/python3"; is_program(usual)) return usual;
  if (const auto found = find_on_path("python3")) return *found;
  throw std::runtime_error(
      "Python 3 draws the figures, and is not there: sudo apt install python3 python3-numpy python3-h5py "
      "python3-matplotlib");
}

/// What it prints is softwall's output, and its exit status softwall's.
[[noreturn]] void become_script(const std::string& name, const std::vector<std::string>& options) {
  std::vector<std::string> words{python(), script(name)};
  words.insert(words.end(), options.begin(), options.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::cout << std::flush;
  execv(arguments[0], arguments.data());
  throw std::system_error(errno, std::generic_category(), words[0]);
}

/// What figures and report have in common.
std::vector<std::string> common_options(const std::string& command, const WantedResults& wanted,
                                        const std::optional<fs::path>& output) {
  std::vector<std::string> words{folder_with_store(wanted.path)};
  tell_if_not_as_last_run(wanted.path, Store::open(words[0], OpenMode::kReadOnly).connection());
  if (output) refuse_own_files(command, *output, wanted.path);
  if (output) words.insert(words.end(), {"-o", *output});
  if (wanted.from) words.insert(words.end(), {"--from", nlohmann::json(*wanted.from).dump()});
  return words;
}

}  // namespace

void draw_figures(const WantedResults& wanted, const FigureOptions& options) {
  auto words = common_options("figures", wanted, options.output);
  words.insert(words.end(), {"--format", options.format, "--style", options.style});
  if (!options.caption) words.emplace_back("--no-caption");
  become_script("figures.py", words);
}

void write_report(const WantedResults& wanted, const ReportOptions& options) {
  auto words = common_options("report", wanted, options.output);
  if (options.watch) words.emplace_back("--watch");
  words.insert(words.end(), {"--softwall", own_program(), "--path", wanted.path});
  become_script("report.py", words);
}

}  // namespace softwall::campaign
