#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "solver/run_directory/checkpoint_digest.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "solver/run_directory/run_files.hpp"

/// Run directories written by hand, as the solver would leave them.
namespace softwall::test {

/// A checkpoint that passes every check: a true header and some bytes behind it.
inline std::filesystem::path write_checkpoint(const RunFiles& run, const std::string& case_id,
                                              std::int64_t step, double time) {
  const auto file = run.checkpoint(step);
  std::filesystem::create_directories(file.parent_path());
  const std::string body = "the state at step " + std::to_string(step);
  CheckpointHeader header;
  header.case_id = case_id;
  header.step = step;
  header.time = time;
  header.bytes = static_cast<std::int64_t>(kCheckpointHeaderBytes + body.size());
  const std::vector<std::uint64_t> pieces = {digest_piece(std::as_bytes(std::span(body)))};
  header.xxh3 = combine_digests(pieces);
  std::ofstream(file, std::ios::binary) << format_header(header) << body;
  return file;
}

inline void write_summary(const RunFiles& run, const std::string& case_id, int attempt,
                          const std::string& outcome, std::int64_t step, double time,
                          const std::string& resumed_from = "") {
  std::filesystem::create_directories(run.directory);
  const nlohmann::json summary = {{"format", 1},
                                  {"case_id", case_id},
                                  {"attempt", attempt},
                                  {"outcome", outcome},
                                  {"reason", "as told"},
                                  {"exit_code", outcome == "finished" ? 0 : 85},
                                  {"step", step},
                                  {"time", time},
                                  {"end_time", time},
                                  {"attempt_steps", step},
                                  {"resumed_from", resumed_from},
                                  {"wall_seconds", 1.0},
                                  {"ns_per_cell_step", 100.0},
                                  {"diagnostics", {{"divergence", 1e-15}}},
                                  {"provenance",
                                   {{"version", "0"},
                                    {"git_revision", "none"},
                                    {"host", "here"},
                                    {"ranks", 1},
                                    {"started", "2026-01-01T00:00:00Z"},
                                    {"ended", "2026-01-01T00:00:01Z"}}}};
  std::ofstream(run.summary()) << summary.dump();
}

}  // namespace softwall::test
