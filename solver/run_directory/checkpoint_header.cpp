#include "solver/run_directory/checkpoint_header.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <system_error>

#include "solver/case/bad_input.hpp"
#include "solver/case/case_id.hpp"
#include "solver/case/file_descriptor.hpp"
#include "solver/case/hexadecimal.hpp"
#include "solver/case/json_text.hpp"
#include "solver/run_directory/checkpoint_digest.hpp"

namespace softwall {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;

std::uint64_t from_hexadecimal(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size() || text.size() != 16)
    throw std::runtime_error("its digest is not 16 hexadecimal digits");
  return value;
}

/// Digest of the header itself: a flipped bit in its step or time would otherwise go unnoticed.
std::string header_check(const json& object) {
  const std::string text = canonical_text(object);
  return hexadecimal(digest_piece(std::as_bytes(std::span(text))));
}

/// The header as it stands in the file.
std::string header_block(const json& object) {
  std::string text = canonical_text(object);
  if (text.size() >= kCheckpointHeaderBytes)
    throw std::length_error("checkpoint header does not fit its block");
  text.resize(kCheckpointHeaderBytes - 1, ' ');
  return text + '\n';
}

/// A changed byte is damage also where it leaves the values alone, 1E-05 for 1e-05.
json header_object(const std::string& text, const std::filesystem::path& file) {
  const json object = parse_json(text, file.string());
  if (!object.is_object() || text != header_block(object)) throw std::runtime_error("its header is damaged");
  return object;
}

/// All members but the check.
json members_of(const CheckpointHeader& header) {
  return {{"format", header.format},       {"case_id", header.case_id},
          {"step", header.step},           {"time", header.time},
          {"bytes", header.bytes},         {"xxh3", hexadecimal(header.xxh3)},
          {"precision", header.precision}, {"grid", header.grid},
          {"length", header.length},       {"git_revision", header.git_revision},
          {"attempt", header.attempt},     {"ranks", header.ranks}};
}

/// Throws unless whole numbers stand where they belong: others cannot be turned into one.
void check_whole_numbers(const json& object) {
  const auto whole = [](const json& value) { return value.is_number_integer(); };
  const json& grid = object.at("grid");
  bool right = grid.is_array() && std::all_of(grid.begin(), grid.end(), whole);
  for (const char* name : {"step", "bytes", "attempt", "ranks"}) right &= whole(object.at(name));
  if (!right) throw CheckpointOfAnotherVersion("its header has a fraction where a whole number belongs");
}

/// From the members of a header that is as its writer left it.
CheckpointHeader header_from(const json& object) {
  if (const json& format = object.at("format"); format != kFormat)
    throw CheckpointOfAnotherVersion("it has format " + format.dump() + ", this program reads format " +
                                     std::to_string(kFormat) +
                                     ": go on with the version that wrote it, or move the file away");
  check_whole_numbers(object);
  CheckpointHeader header;
  header.format = kFormat;
  header.case_id = object.at("case_id");
  header.step = object.at("step");
  header.time = object.at("time");
  header.bytes = object.at("bytes");
  header.xxh3 = from_hexadecimal(object.at("xxh3"));
  header.precision = object.at("precision");
  header.grid = object.at("grid");
  header.length = object.at("length");
  header.git_revision = object.at("git_revision");
  header.attempt = object.at("attempt");
  header.ranks = object.at("ranks");
  // A number too large for its member, or a member that this format does not have.
  if (members_of(header) != object)
    throw CheckpointOfAnotherVersion("its header is not one of this program's format");
  return header;
}

/// Throws unless the header is as its writer left it. What cannot be read after this is not damaged.
json checked_members(json object) {
  const auto check = object.find("check");
  if (check == object.end()) throw std::runtime_error("its header is incomplete");
  const json told = *check;
  object.erase(check);
  if (told != header_check(object)) throw std::runtime_error("its header is damaged");
  return object;
}

/// The system's refusal, which says nothing about what is in the file.
std::system_error unreadable() { return {errno, std::generic_category(), "it cannot be read"}; }

std::string header_text(const std::filesystem::path& file) {
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!descriptor) throw unreadable();
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode))
    throw std::runtime_error("it is not a regular file");
  std::string text(kCheckpointHeaderBytes, '\0');
  const ssize_t length = ::pread(descriptor.get(), text.data(), text.size(), 0);
  if (length < 0) throw unreadable();
  if (length != static_cast<ssize_t>(text.size())) throw std::runtime_error("it is shorter than its header");
  return text;
}

/// The step in a name that RunFiles::checkpoint() gave.
std::optional<std::int64_t> step_in_name(const std::filesystem::path& file) {
  constexpr std::string_view kBegin = "checkpoint-", kEnd = ".h5";
  constexpr std::size_t kFewestDigits = 9;
  const std::string name = file.filename();
  if (name.size() < kBegin.size() + kFewestDigits + kEnd.size()) return std::nullopt;
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) return std::nullopt;
  const char* const first = name.data() + kBegin.size();
  const char* const last = name.data() + name.size() - kEnd.size();
  std::int64_t step = 0;
  const auto [end, error] = std::from_chars(first, last, step);
  return error == std::errc() && end == last && step >= 0 ? std::optional(step) : std::nullopt;
}

/// Throws std::runtime_error with what is wrong; the header is set as far as it was read.
void verify(const std::filesystem::path& file, const std::string& case_id, CheckpointHeader& header) {
  header = read_checkpoint_header(file);
  if (header.case_id != case_id)
    throw std::runtime_error("it belongs to case " + printable_excerpt(header.case_id) + ", not to " +
                             case_id);
  if (const auto named = step_in_name(file); named && *named != header.step)
    throw std::runtime_error("its name says step " + std::to_string(*named) + ", its header " +
                             std::to_string(header.step));
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(file));
  if (size != header.bytes)
    throw std::runtime_error("it has " + std::to_string(size) + " bytes, its header says " +
                             std::to_string(header.bytes));
  if (digest_file(file) != header.xxh3)
    throw std::runtime_error("its contents do not match the digest in its header");
}

/// The step in the header, or that in the name where the header is damaged or cannot be read: a damaged one
/// that came last would be passed over without a word.
std::int64_t step_of(const std::filesystem::path& file) {
  try {
    return read_checkpoint_header(file).step;
  } catch (const std::runtime_error&) {
    return step_in_name(file).value_or(-1);
  }
}

}  // namespace

std::string format_header(const CheckpointHeader& header) {
  json object = members_of(header);
  object["check"] = header_check(object);
  return header_block(object);
}

CheckpointHeader read_checkpoint_header(const std::filesystem::path& file) {
  try {
    return header_from(checked_members(header_object(header_text(file), file)));
  } catch (const BadInput&) {
    throw std::runtime_error("its header is damaged");
  } catch (const json::exception&) {
    throw CheckpointOfAnotherVersion("its header lacks a member of this program's format");
  }
}

bool tells_nothing_of_contents(const std::exception& refusal) {
  return dynamic_cast<const std::runtime_error*>(&refusal) == nullptr ||  // out of memory
         dynamic_cast<const std::system_error*>(&refusal) != nullptr ||
         dynamic_cast<const CheckpointOfAnotherVersion*>(&refusal) != nullptr;
}

CheckpointVerdict verify_checkpoint(const std::filesystem::path& file, const std::string& case_id) {
  CheckpointVerdict verdict;
  try {
    verify(file, case_id, verdict.header);
    verdict.valid = true;
  } catch (const std::exception& error) {
    verdict.unreadable = tells_nothing_of_contents(error);
    verdict.reason = file.filename().string() + ": " + error.what();
  }
  return verdict;
}

std::vector<std::filesystem::path> checkpoint_ladder(const RunFiles& run) {
  std::vector<std::pair<std::int64_t, std::filesystem::path>> found;
  std::error_code error;
  std::filesystem::directory_iterator folder(run.checkpoints(), error);
  if (error && error != std::errc::no_such_file_or_directory)
    throw std::system_error(error, run.checkpoints().string() + " cannot be read");
  for (const auto& entry : folder)
    if (step_in_name(entry.path())) found.emplace_back(step_of(entry.path()), entry.path());
  std::sort(found.rbegin(), found.rend());
  std::vector<std::filesystem::path> files;
  for (auto& [step, file] : found) files.push_back(std::move(file));
  return files;
}

void write_header(const std::filesystem::path& file, const CheckpointHeader& header) {
  const std::string text = format_header(header);
  FileDescriptor descriptor(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  const auto written = descriptor ? ::pwrite(descriptor.get(), text.data(), text.size(), 0) : -1;
  if (written != static_cast<ssize_t>(text.size()) || !descriptor.close())
    throw std::system_error(errno, std::generic_category(), "cannot write the header of " + file.string());
}

}  // namespace softwall
