#include "solver/run_directory/checkpoint_header.hpp"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <span>

#include "solver/case/case_id.hpp"
#include "solver/case/hexadecimal.hpp"
#include "tests/case/examples.hpp"

namespace softwall {
namespace {

constexpr const char* kId = "0123456789abcdef";

CheckpointHeader example(std::int64_t step = 1200) {
  CheckpointHeader header;
  header.case_id = kId;
  header.step = step;
  header.time = 12.000000000000002;
  header.grid = {32, 40, 16};
  header.length = {6.0, 2.5, 3.0};
  header.git_revision = "abcdef123456-modified";
  header.attempt = 3;
  header.ranks = 2;
  return header;
}

std::string random_bytes(std::size_t size) {
  std::mt19937_64 random(size);
  std::string bytes(size, '\0');
  for (auto& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

/// A file as the solver makes it: data behind an empty header block, then the header put in front.
void write_checkpoint(const std::filesystem::path& file, const std::string& data,
                      CheckpointHeader header = example()) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << std::string(kCheckpointHeaderBytes, ' ') << data;
  header.bytes = static_cast<std::int64_t>(kCheckpointHeaderBytes + data.size());
  header.xxh3 = digest_file(file);
  write_header(file, header);
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void rewrite(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// These members as a header block with a check that fits.
std::string sealed(nlohmann::json members) {
  members.erase("check");
  const std::string checked = canonical_text(members);
  members["check"] = hexadecimal(digest_piece(std::as_bytes(std::span(checked))));
  std::string text = canonical_text(members);
  text.resize(kCheckpointHeaderBytes - 1, ' ');
  return text + '\n';
}

std::string refusal(const std::filesystem::path& file) {
  const CheckpointVerdict verdict = verify_checkpoint(file, kId);
  EXPECT_EQ(verdict.valid, verdict.reason.empty());
  return verdict.reason;
}

class Checkpoint : public ::testing::Test {
 protected:
  tests::TemporaryFolder folder_;
  RunFiles run_{folder_.path()};
};

TEST_F(Checkpoint, HeaderComesBackExactly) {
  write_checkpoint(run_.checkpoint(1200), "data");
  const CheckpointHeader header = read_checkpoint_header(run_.checkpoint(1200));
  const CheckpointHeader wanted = example();
  EXPECT_EQ(header.case_id, wanted.case_id);
  EXPECT_EQ(header.step, wanted.step);
  EXPECT_EQ(header.time, wanted.time);
  EXPECT_EQ(header.bytes, 4100);
  EXPECT_EQ(header.precision, "double");
  EXPECT_EQ(header.grid, wanted.grid);
  EXPECT_EQ(header.length, wanted.length);
  EXPECT_EQ(header.git_revision, wanted.git_revision);
  EXPECT_EQ(header.attempt, 3);
  EXPECT_EQ(header.ranks, 2);
  EXPECT_EQ(format_header(header).size(), kCheckpointHeaderBytes);
  EXPECT_EQ(format_header(header).back(), '\n');
  EXPECT_EQ(refusal(run_.checkpoint(1200)), "");
}

TEST_F(Checkpoint, TooLongAHeaderIsRefused) {
  CheckpointHeader header = example();
  header.git_revision.assign(5000, 'x');
  EXPECT_THROW(static_cast<void>(format_header(header)), std::length_error);
}

/// The definition in checkpoint_digest.hpp, written down a second time.
TEST_F(Checkpoint, DigestIsThatOfThePiecesDigests) {
  const std::string data = random_bytes(2 * kDigestPieceBytes + 12345);
  write_checkpoint(run_.checkpoint(1), data);
  std::string digests;
  std::vector<std::uint64_t> pieces;
  for (std::size_t at = 0; at < data.size(); at += kDigestPieceBytes) {
    const std::uint64_t digest = XXH3_64bits(data.data() + at, std::min(kDigestPieceBytes, data.size() - at));
    for (int byte = 0; byte < 8; ++byte) digests += static_cast<char>(digest >> (8 * byte));
    pieces.push_back(digest_piece_of_file(run_.checkpoint(1), at / kDigestPieceBytes));
  }
  const CheckpointHeader header = read_checkpoint_header(run_.checkpoint(1));
  EXPECT_EQ(header.xxh3, XXH3_64bits(digests.data(), digests.size()));
  EXPECT_EQ(combine_digests(pieces), header.xxh3);
  EXPECT_EQ(digest_pieces(header.bytes), 3U);
  EXPECT_EQ(digest_pieces(4096), 0U);
  EXPECT_EQ(digest_pieces(4097), 1U);
  EXPECT_EQ(digest_pieces(0), 0U);
  EXPECT_EQ(digest_pieces(static_cast<std::int64_t>(4096 + kDigestPieceBytes)), 1U);
}

TEST_F(Checkpoint, AnyFlippedBitIsNoticed) {
  const auto file = run_.checkpoint(1);
  write_checkpoint(file, random_bytes(500));
  const std::string sound = bytes_of(file);
  for (std::size_t at = 0; at < sound.size(); at += (at > 600 && at < 4080 ? 97 : 1)) {
    std::string damaged = sound;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    rewrite(file, damaged);
    EXPECT_NE(refusal(file), "") << "byte " << at;
  }
}

TEST_F(Checkpoint, AHeaderThatOnlyLooksDifferentIsNoticed) {
  const auto file = run_.checkpoint(1);
  CheckpointHeader header = example();
  header.time = 1e-7;
  write_checkpoint(file, "data", header);
  std::string damaged = bytes_of(file);
  damaged[damaged.find("1e-07") + 1] = 'E';  // one bit
  rewrite(file, damaged);
  EXPECT_NE(refusal(file), "");
}

TEST_F(Checkpoint, AnyOtherLengthIsNoticed) {
  const auto file = run_.checkpoint(1);
  write_checkpoint(file, random_bytes(500));
  const std::string sound = bytes_of(file);
  for (const std::size_t length : {0, 1, 100, 4095, 4096, 4097, 4595}) {
    rewrite(file, sound.substr(0, length));
    EXPECT_NE(refusal(file), "") << length;
  }
  rewrite(file, sound + '\0');
  EXPECT_NE(refusal(file), "");
}

TEST_F(Checkpoint, RefusalsSayWhy) {
  const auto file = run_.checkpoint(1);
  EXPECT_NE(refusal(file).find("cannot be read"), std::string::npos) << refusal(file);
  std::filesystem::create_directories(file);
  EXPECT_NE(refusal(file).find("not a regular file"), std::string::npos) << refusal(file);
  std::filesystem::remove(file);
  write_checkpoint(file, "data");
  const auto verdict = verify_checkpoint(file, "fedcba9876543210");
  EXPECT_FALSE(verdict.valid);
  EXPECT_NE(verdict.reason.find("belongs to case 0123456789abcdef, not to fedcba9876543210"),
            std::string::npos)
      << verdict.reason;
  EXPECT_NE(verdict.reason.find("checkpoint-000000001.h5"), std::string::npos) << verdict.reason;
  CheckpointHeader newer = example();
  newer.format = 2;
  write_checkpoint(file, "data", newer);
  EXPECT_NE(refusal(file).find("format 2"), std::string::npos) << refusal(file);
  rewrite(file, std::string(5000, '\0'));
  EXPECT_NE(refusal(file).find("header is damaged"), std::string::npos) << refusal(file);
}

/// Its writer may have meant it otherwise than we read it, but nothing in it is damaged.
TEST_F(Checkpoint, AHeaderOfAnotherVersionSaysNothingOfTheContents) {
  const auto file = run_.checkpoint(1);
  CheckpointHeader newer = example(1);
  newer.format = 2;
  write_checkpoint(file, "data", newer);
  EXPECT_TRUE(verify_checkpoint(file, kId).unreadable);
  std::string damaged = bytes_of(file);
  damaged[damaged.find(kId)] = 'x';
  rewrite(file, damaged);
  EXPECT_FALSE(verify_checkpoint(file, kId).unreadable);

  write_checkpoint(file, "data", example(1));
  nlohmann::json members = nlohmann::json::parse(bytes_of(file).substr(0, kCheckpointHeaderBytes));
  members["steps_per_block"] = 7;
  rewrite(file, sealed(members) + "data");
  EXPECT_TRUE(verify_checkpoint(file, kId).unreadable);
  members.erase("steps_per_block");
  members.erase("ranks");
  rewrite(file, sealed(members) + "data");
  EXPECT_TRUE(verify_checkpoint(file, kId).unreadable);
}

TEST_F(Checkpoint, LadderIsNewestFirstByContent) {
  EXPECT_TRUE(checkpoint_ladder(run_).empty());
  write_checkpoint(run_.checkpoint(100), "a", example(100));
  write_checkpoint(run_.checkpoint(300), "c", example(300));
  write_checkpoint(run_.checkpoint(200), "b", example(900));  // its name lies, its content decides
  rewrite(run_.checkpoint(999), "nonsense");                  // only its name is left
  rewrite(run_.checkpoints() / "checkpoint-000000400.h5.tmp", "left by a crash");
  rewrite(run_.checkpoints() / "checkpoint-00000400.h5", "eight digits");
  rewrite(run_.checkpoints() / ".checkpoint-000000400.h5", "hidden");
  const std::vector<std::filesystem::path> wanted{run_.checkpoint(999), run_.checkpoint(200),
                                                  run_.checkpoint(300), run_.checkpoint(100)};
  EXPECT_EQ(checkpoint_ladder(run_), wanted);
  EXPECT_EQ(run_.checkpoint(1234).filename(), "checkpoint-000001234.h5");
}

}  // namespace
}  // namespace softwall
