#include "campaign/launch/make_launcher.hpp"

#include <array>

#include "campaign/launch/process_launcher.hpp"
#include "campaign/launch/slurm_launcher.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

struct Kind {
  const char* name;
  std::unique_ptr<Launcher> (*make)(const Execution&);
};

constexpr std::array<Kind, 2> kKinds = {{
    {"local",
     [](const Execution&) { return std::unique_ptr<Launcher>(std::make_unique<ProcessLauncher>()); }},
    {"slurm",
     [](const Execution& execution) {
       return std::unique_ptr<Launcher>(std::make_unique<SlurmLauncher>(execution.slurm));
     }},
}};

}  // namespace

std::unique_ptr<Launcher> make_launcher(const Execution& execution) {
  for (const Kind& kind : kKinds) {
    if (execution.launcher == kind.name) return kind.make(execution);
  }
  throw BadInput("execution.launcher", {{"", execution.launcher, "a launcher of this softwall"}});
}

std::vector<std::string> launcher_names() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

}  // namespace softwall::campaign
