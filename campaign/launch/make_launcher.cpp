#include "campaign/launch/make_launcher.hpp"

#include <array>

#include "campaign/launch/process_launcher.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

struct Kind {
  const char* name;
  std::unique_ptr<Launcher> (*make)();
};

constexpr std::array<Kind, 1> kKinds = {{
    {"local", [] { return std::unique_ptr<Launcher>(std::make_unique<ProcessLauncher>()); }},
}};

}  // namespace

std::unique_ptr<Launcher> make_launcher(const std::string& name) {
  for (const Kind& kind : kKinds) {
    if (name == kind.name) return kind.make();
  }
  throw BadInput("execution.launcher", {{"", name, "a launcher of this softwall"}});
}

std::vector<std::string> launcher_names() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

}  // namespace softwall::campaign
