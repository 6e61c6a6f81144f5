#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

/// The digest of a checkpoint's data: bytes from 4096 (behind the header) to the end are cut into pieces of
/// 16 MiB; each piece's XXH3-64 is written as 8 bytes, little-endian, one after the other; the XXH3-64 of
/// those is the file's. So ranks can share the work and the result does not depend on their number.
namespace softwall {

inline constexpr std::size_t kCheckpointHeaderBytes = 4096;
inline constexpr std::size_t kDigestPieceBytes = std::size_t{16} << 20;

/// XXH3-64 of one piece (16 MiB, the last one may be shorter).
[[nodiscard]] std::uint64_t digest_piece(std::span<const std::byte> piece);

/// The file's digest from those of its pieces, in order.
[[nodiscard]] std::uint64_t combine_digests(std::span<const std::uint64_t> pieces);

/// Number of pieces of a file of this size.
[[nodiscard]] std::size_t digest_pieces(std::int64_t file_bytes);

/// Digest of the piece with this number, read from the file. Throws std::system_error.
[[nodiscard]] std::uint64_t digest_piece_of_file(const std::filesystem::path& file, std::size_t piece);

/// All pieces by one process. Throws std::system_error.
[[nodiscard]] std::uint64_t digest_file(const std::filesystem::path& file);

}  // namespace softwall
