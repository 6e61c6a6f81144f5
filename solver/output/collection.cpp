#include "solver/output/collection.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include "solver/case/atomic_file.hpp"
#include "solver/case/file_descriptor.hpp"
#include "solver/run_directory/hdf5_image.hpp"

namespace softwall::output {
namespace {

constexpr std::string_view kEnd = "</Grid></Domain></Xdmf>\n";

/// <begin><step>.h5, and nothing else that a user may have put beside it.
bool is_moment(const std::string& name, const std::string& begin) {
  constexpr std::string_view kEnding = ".h5";
  if (!name.starts_with(begin) || !name.ends_with(kEnding)) return false;
  const std::string step = name.substr(begin.size(), name.size() - begin.size() - kEnding.size());
  return !step.empty() && step.find_first_not_of("0123456789") == std::string::npos;
}

/// In the order of their steps.
std::vector<std::filesystem::path> moments_beside(const std::filesystem::path& collection) {
  const std::string begin = collection.stem().string() + "-";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(collection.parent_path())) {
    const auto& file = entry.path();
    if (is_moment(file.filename(), begin)) files.push_back(file);
  }
  std::ranges::sort(files);
  return files;
}

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw std::system_error(errno, std::generic_category(), "cannot write " + file.string());
}

}  // namespace

void Collection::add(const std::filesystem::path& moment) {
  const std::string name = moment.filename().string(), text = describe_(moment);
  const std::size_t hash = std::hash<std::string>()(text);
  std::error_code gone;
  const bool as_left = !known_.empty() && std::filesystem::file_size(file_, gone) == bytes_ && !gone;
  const auto known = known_.find(name);
  if (as_left && known != known_.end() && known->second == hash) return;  // made once more after a resume
  if (!as_left || known_.rbegin()->first >= name) return write_anew();
  append(text);
  known_[name] = hash;
}

void Collection::remove_later_than(const std::filesystem::path& moment) {
  if (!std::filesystem::is_directory(file_.parent_path())) return;
  bool removed = false;
  for (const auto& file : moments_beside(file_))
    if (file.filename() > moment.filename()) removed = std::filesystem::remove(file) || removed;
  if (removed) write_anew();
}

void Collection::write_anew() {
  known_.clear();
  std::string all = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain>\n<Grid Name=\"" +
                    file_.stem().string() + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const auto& moment : moments_beside(file_)) {
    const analysis::QuietHdf5 quiet;
    try {
      const std::string text = describe_(moment);
      known_[moment.filename().string()] = std::hash<std::string>()(text);
      all += text;
    } catch (const std::runtime_error&) {  // a damaged file is left out
      continue;
    }
  }
  all += kEnd;
  write_atomically(file_, all);
  bytes_ = all.size();
}

/// In place of the end, which follows again: in one go, so that a reader meets half of it hardly ever. Where
/// a power loss leaves half of it, the next attempt makes the file anew.
void Collection::append(const std::string& text) {
  FileDescriptor file(::open(file_.c_str(), O_WRONLY | O_CLOEXEC));
  const auto end = static_cast<off_t>(bytes_ - kEnd.size());
  if (!file || ::lseek(file.get(), end, SEEK_SET) != end) fail(file_);
  write_all(file.get(), text + std::string(kEnd), file_);
  if (!file.close()) fail(file_);
  bytes_ += text.size();
}

}  // namespace softwall::output
