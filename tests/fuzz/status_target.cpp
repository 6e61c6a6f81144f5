#include <nlohmann/json.hpp>

#include "solver/run_directory/report_file.hpp"
#include "solver/run_directory/run_record.hpp"
#include "solver/run_directory/status.hpp"
#include "solver/run_directory/summary.hpp"
#include "tests/fuzz/in_memory_file.hpp"

namespace {

/// Proves nothing, or is a report that its own text gives again.
template <class Report>
void read(const std::filesystem::path& file) {
  using namespace softwall;
  const auto report = read_report<Report>(file);
  if (!report) return;
  nlohmann::json written = *report;
  const std::string text = written.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const fuzz::InMemoryFile copy(text.data(), text.size());
  fuzz::require(read_report<Report>(copy.path()).has_value(), "a report that was written cannot be read");
}

}  // namespace

/// status.json, and the two other small reports of a run directory.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const softwall::fuzz::InMemoryFile file(data, size);
  read<softwall::Status>(file.path());
  read<softwall::Summary>(file.path());
  read<softwall::RunRecord>(file.path());
  return 0;
}
