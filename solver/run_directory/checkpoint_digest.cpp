#include "solver/run_directory/checkpoint_digest.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <system_error>
#include <vector>

#include "solver/case/file_descriptor.hpp"

namespace softwall {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw std::system_error(errno, std::generic_category(), "cannot read " + file.string());
}

/// Fills the buffer from `offset`, or as far as the file reaches. Returns the bytes read.
std::size_t read_at(int descriptor, std::span<std::byte> buffer, std::size_t offset,
                    const std::filesystem::path& file) {
  std::size_t filled = 0;
  while (filled < buffer.size()) {
    const ssize_t count = ::pread(descriptor, buffer.data() + filled, buffer.size() - filled,
                                  static_cast<off_t>(offset + filled));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(file);
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  return filled;
}

std::size_t piece_offset(std::size_t piece) { return kCheckpointHeaderBytes + piece * kDigestPieceBytes; }

}  // namespace

std::uint64_t digest_piece(std::span<const std::byte> piece) {
  return XXH3_64bits(piece.data(), piece.size());
}

std::uint64_t combine_digests(std::span<const std::uint64_t> pieces) {
  std::vector<unsigned char> bytes;
  bytes.reserve(pieces.size() * 8);
  for (const std::uint64_t digest : pieces)
    for (int shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<unsigned char>(digest >> shift));
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::size_t digest_pieces(std::int64_t file_bytes) {
  const auto data = static_cast<std::size_t>(file_bytes) - kCheckpointHeaderBytes;
  if (file_bytes <= static_cast<std::int64_t>(kCheckpointHeaderBytes)) return 0;
  return (data + kDigestPieceBytes - 1) / kDigestPieceBytes;
}

std::uint64_t digest_piece_of_file(const std::filesystem::path& file, std::size_t piece) {
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor) fail(file);
  std::vector<std::byte> buffer(kDigestPieceBytes);
  const std::size_t size = read_at(descriptor.get(), buffer, piece_offset(piece), file);
  return digest_piece({buffer.data(), size});
}

std::uint64_t digest_file(const std::filesystem::path& file) {
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor) fail(file);
  std::vector<std::byte> buffer(kDigestPieceBytes);
  std::vector<std::uint64_t> digests;
  while (const std::size_t size = read_at(descriptor.get(), buffer, piece_offset(digests.size()), file))
    digests.push_back(digest_piece({buffer.data(), size}));
  return combine_digests(digests);
}

}  // namespace softwall
