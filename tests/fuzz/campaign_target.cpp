#include <nlohmann/json.hpp>
#include <set>

#include "campaign/core/campaign_file.hpp"
#include "solver/case/bad_input.hpp"
#include "tests/fuzz/in_memory_file.hpp"

/// campaign.json: is refused as bad input, or gives cases, each of which has an id of its own.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace softwall;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const campaign::Campaign read = campaign::parse_campaign(text);
    fuzz::require(!read.cases.empty(), "a campaign without cases");
    std::set<std::string> ids;
    for (const auto& one : read.cases)
      fuzz::require(ids.insert(one.definition.id).second, "two cases of a campaign have one id");
  } catch (const BadInput&) {
    return 0;
  }
  return 0;
}
