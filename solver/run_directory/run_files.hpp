#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

/// Names of the files in a run directory: the whole contract between softwall and softwall-dns.
/// Nobody else builds such a path by hand.
namespace softwall {

struct RunFiles {
  std::filesystem::path directory;

  [[nodiscard]] std::filesystem::path case_file() const { return directory / "case.json"; }
  [[nodiscard]] std::filesystem::path run_record() const { return directory / "run.json"; }
  [[nodiscard]] std::filesystem::path status() const { return directory / "status.json"; }
  [[nodiscard]] std::filesystem::path summary() const { return directory / "summary.json"; }
  [[nodiscard]] std::filesystem::path statistics() const { return directory / "statistics.h5"; }
  [[nodiscard]] std::filesystem::path spectra() const { return directory / "spectra.h5"; }
  [[nodiscard]] std::filesystem::path log() const { return directory / "solver.log"; }
  [[nodiscard]] std::filesystem::path lock() const { return directory / "solver.lock"; }
  [[nodiscard]] std::filesystem::path layout() const { return directory / "layout.json"; }
  [[nodiscard]] std::filesystem::path checkpoints() const { return directory / "checkpoints"; }
  [[nodiscard]] std::filesystem::path fields() const { return directory / "fields"; }
  [[nodiscard]] std::filesystem::path planes() const { return directory / "planes"; }

  /// checkpoints/checkpoint-000001234.h5
  [[nodiscard]] std::filesystem::path checkpoint(std::int64_t step) const;
  /// fields/fields-000001234.h5
  [[nodiscard]] std::filesystem::path fields_of(std::int64_t step) const;
  /// planes/planes-000001234.h5
  [[nodiscard]] std::filesystem::path planes_of(std::int64_t step) const;
};

}  // namespace softwall
