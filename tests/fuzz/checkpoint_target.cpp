#include <nlohmann/json.hpp>
#include <span>

#include "solver/case/bad_input.hpp"
#include "solver/case/case_id.hpp"
#include "solver/case/hexadecimal.hpp"
#include "solver/case/json_text.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "tests/fuzz/in_memory_file.hpp"

namespace {

using namespace softwall;

constexpr const char* kCaseId = "0123456789abcdef";
constexpr std::string_view kData = "what stands behind the header";

/// The header that the solver would write in front of kData.
nlohmann::json right_header() {
  const std::string file = std::string(kCheckpointHeaderBytes, ' ').append(kData);
  CheckpointHeader header;
  header.case_id = kCaseId;
  header.bytes = static_cast<std::int64_t>(file.size());
  header.xxh3 = digest_file(fuzz::InMemoryFile(file.data(), file.size()).path());
  return parse_json(format_header(header), "header");
}

/// A file with right digests whose header has these members, or others in the place of its own.
std::string sealed_file(std::string_view members) {
  nlohmann::json header = right_header();
  header.erase("check");
  try {
    const nlohmann::json other = parse_json(members, "members");
    if (other.is_object()) header.update(other);
  } catch (const BadInput&) {
    return {};
  }
  const std::string checked = canonical_text(header);
  header["check"] = hexadecimal(digest_piece(std::as_bytes(std::span(checked))));
  std::string file = canonical_text(header);
  if (file.size() >= kCheckpointHeaderBytes) return {};
  file.resize(kCheckpointHeaderBytes - 1, ' ');
  return (file + '\n').append(kData);
}

}  // namespace

/// A checkpoint: is refused with a reason, or is of this case, whole, and has a header that its own text
/// gives again. A file that begins with an m holds, behind it, members for a header whose digests are right:
/// of changed bytes they let none through.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  const bool is_sealed = bytes.starts_with('m');
  if (is_sealed) bytes = sealed_file(std::string_view(bytes).substr(1));
  const fuzz::InMemoryFile file(bytes.data(), bytes.size());
  const CheckpointVerdict verdict = verify_checkpoint(file.path(), kCaseId);
  fuzz::require(verdict.valid == verdict.reason.empty(), "a verdict without a reason");
  // Whoever seals what we cannot read is another version.
  fuzz::require(is_sealed || !verdict.unreadable, "what is there counts as not readable");
  if (!verdict.valid) return 0;
  fuzz::require(verdict.header.case_id == kCaseId, "the checkpoint of another case was accepted");
  fuzz::require(format_header(verdict.header) == bytes.substr(0, kCheckpointHeaderBytes),
                "a header read and written is another");
  return 0;
}
