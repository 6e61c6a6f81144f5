#include "campaign/commands/as_last_run.hpp"

#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/store/text_width.hpp"

namespace softwall::campaign {

void tell_if_not_as_last_run(const std::filesystem::path& named, Connection& store) {
  const std::filesystem::path file = campaign_file(named);
  std::ifstream in(file);
  if (!in) return;  // a folder of which only the store is left
  const std::string now{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  Statement as_run = store.prepare("SELECT spec, name FROM campaign");
  if (!as_run.step() || as_run.text(0) == now) return;
  std::cerr << "These results are of the campaign \"" << printable(as_run.text(1))
            << "\" as it was last run; " << printable(file.string())
            << " is another one, or has been changed since.\n";
}

}  // namespace softwall::campaign
