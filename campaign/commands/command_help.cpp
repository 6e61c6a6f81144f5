#include "campaign/commands/command_help.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace softwall::campaign {
namespace {

/// What the help of a command opens with, by its name.
const std::map<std::string, std::string>& examples() {
  static const std::map<std::string, std::string> kExamples = {
      {"init", "softwall init my-sweep"},
      {"run",
       "softwall run my-sweep\n"
       "nohup softwall run my-sweep > my-sweep.log &    # goes on when the terminal is closed"},
      {"resume", "softwall resume my-sweep"},
      {"plan", "softwall plan my-sweep"},
      {"status",
       "softwall status my-sweep\n"
       "softwall status my-sweep --why       # what each case waits for\n"
       "softwall status my-sweep --watch"},
      {"table",
       "softwall table my-sweep\n"
       "softwall table my-sweep --from 150    # averages from t = 150 on"},
      {"query",
       "softwall query my-sweep \"SELECT label, re_tau, re_tau_ci95 FROM results ORDER BY re_tau\"\n"
       "softwall query my-sweep \"SELECT * FROM results WHERE G < 1\" --vertical"},
      {"export", "softwall export my-sweep --csv -o results.csv"},
      {"figures", "softwall figures my-sweep --format pdf --style journal --no-caption -o paper/figures"},
      {"report",
       "softwall report my-sweep    # writes my-sweep/report.html\n"
       "softwall report my-sweep --watch"},
      {"verify",
       "softwall verify my-sweep\n"
       "softwall verify my-sweep G=0.5"},
      {"clean",
       "softwall clean my-sweep             # lists them\n"
       "softwall clean my-sweep --remove"},
      {"rebuild", "softwall rebuild my-sweep"},
      {"completion",
       "softwall completion bash > ~/.local/share/bash-completion/completions/softwall\n"
       "softwall completion fish > ~/.config/fish/completions/softwall.fish"}};
  return kExamples;
}

/// Puts the examples of a command behind its first line.
class HelpWithExamples : public CLI::Formatter {
 public:
  std::string make_description(const CLI::App* app) const override {
    std::string text = CLI::Formatter::make_description(app);
    const auto found = examples().find(app->get_name());
    if (found == examples().end()) return text;
    std::string lines = found->second;
    for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 5)
      lines.insert(at + 1, 4, ' ');
    return text + "\nExamples:\n    " + lines + "\n\n";
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_with_examples() { return std::make_shared<HelpWithExamples>(); }

}  // namespace softwall::campaign
