#include <nlohmann/json.hpp>

#include "solver/case/bad_input.hpp"
#include "solver/case/case.hpp"
#include "tests/fuzz/in_memory_file.hpp"

/// case.json: is refused as bad input, or is a case that its own text gives again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace softwall;
  const std::string text(reinterpret_cast<const char*>(data), size);
  Case read;
  try {
    read = parse_case(text);
  } catch (const BadInput&) {
    return 0;
  }
  const nlohmann::json written = to_json(read);
  const Case again = parse_case(written.dump());
  fuzz::require(again.id == read.id, "a case written and read has another id");
  fuzz::require(to_json(again) == written, "a case written and read is another");
  return 0;
}
