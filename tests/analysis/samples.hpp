#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "solver/run_directory/statistics_file.hpp"

/// Statistics with known answers, for the tests of analysis/.
namespace softwall::analysis::samples {

inline void set_uniform_grid(BlockStatistics& s, double height, int cells) {
  s.y_center.clear();
  s.y_face.clear();
  for (int j = 0; j <= cells; ++j) s.y_face.push_back(height * j / cells);
  for (int j = 0; j < cells; ++j) s.y_center.push_back(height * (j + 0.5) / cells);
}

/// Blocks of `length` from t = `start`.
inline void set_blocks(BlockStatistics& s, int blocks, double start = 100.0, double length = 2.0) {
  s.start.clear();
  s.end.clear();
  for (int b = 0; b < blocks; ++b) {
    s.start.push_back(start + b * length);
    s.end.push_back(start + (b + 1) * length);
  }
  s.weight.assign(blocks, length);
}

/// The same profile in every block, or changed from block to block by `in_block`.
inline void add_profile(BlockStatistics& s, const std::string& name, Location location,
                        const std::function<double(double y, std::size_t block)>& in_block) {
  const auto& y = location == Location::kCenter ? s.y_center : s.y_face;
  Profile profile{location, {}};
  for (std::size_t b = 0; b < s.blocks(); ++b) {
    for (const double at : y) profile.values.push_back(in_block(at, b));
  }
  s.profiles[name] = profile;
}

/// Flow over an elastic wall (2 < y < 2.5) whose mean has exactly the log law asked for:
/// from yt+ = 25 to 0.6 of the way to the maximum, dU+/dyt+ = 1 / (k_plus_dk (yt + d)+).
struct ElasticModel {
  double reynolds = 2800.0, re_tau_w = 193.0, re_tau = 240.5;
  double y_max = -0.206, d = 0.12, k_plus_dk = 0.25, delta_u_plus = 14.5;
  [[nodiscard]] double u_tau() const { return re_tau / reynolds; }
  [[nodiscard]] double shear_bottom() const { return re_tau_w * re_tau_w / (reynolds * reynolds); }
  [[nodiscard]] double driving_gradient() const { return 0.5 * (shear_bottom() + u_tau() * u_tau()); }
  /// U at y, for 0 < y < 2.5.
  [[nodiscard]] double u(double y) const {
    const double yt = 2.0 - y, top = 1.0 - y_max, log_end = 0.6 * top, d_plus = d * re_tau;
    const auto law = [&](double at) {
      return std::log(at * re_tau + d_plus) / k_plus_dk + 5.5 - delta_u_plus;
    };
    if (yt <= 0.0) return 0.0;
    if (yt * re_tau < 25.0) {  // a parabola from the interface at rest that continues value and slope
      const double t = yt * re_tau / 25.0, bend = law(25.0 / re_tau) - 25.0 / (k_plus_dk * (25.0 + d_plus));
      return (law(25.0 / re_tau) * t + bend * t * (1.0 - t)) * u_tau();
    }
    if (yt <= log_end) return law(yt) * u_tau();
    // Beyond: a parabola that continues value and slope and has its maximum at `top`.
    const double slope = 1.0 / (k_plus_dk * (log_end + d)), curvature = -slope / (2.0 * (top - log_end));
    const double x = yt - log_end;
    return (law(log_end) + slope * x + curvature * x * x) * u_tau();
  }
  [[nodiscard]] double u_max() const {
    const double top = 1.0 - y_max, log_end = 0.6 * top;
    return u(2.0 - log_end) + 0.5 * (top - log_end) / (k_plus_dk * (log_end + d)) * u_tau();
  }
};

inline BlockStatistics elastic_statistics(const ElasticModel& model, int blocks, int cells = 320) {
  BlockStatistics s;
  s.case_id = "0123456789abcdef";
  s.reynolds = model.reynolds;
  s.elastic = true;
  set_uniform_grid(s, 2.5, cells);
  set_blocks(s, blocks);
  add_profile(s, "u", Location::kCenter, [&](double y, std::size_t) { return model.u(y); });
  s.series["driving_gradient"].assign(blocks, model.driving_gradient());
  s.series["wall_shear_bottom"].assign(blocks, model.shear_bottom());
  s.series["interface_max"].assign(blocks, 0.095);
  s.series["interface_rms"].assign(blocks, 0.025);
  return s;
}

/// Columns of a reference file: comment lines, one line of names, then numbers.
inline std::vector<std::vector<double>> read_columns(const std::string& file) {
  std::ifstream in(std::string(SOFTWALL_REFERENCE_DATA) + "/" + file);
  std::vector<std::vector<double>> columns;
  std::string line;
  bool names_seen = false;
  while (std::getline(in, line)) {
    if (line.starts_with('#')) continue;
    if (!names_seen) {
      names_seen = true;
      continue;
    }
    std::stringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (i == columns.size()) columns.emplace_back();
      columns[i].push_back(std::stod(cell));
    }
  }
  return columns;
}

/// First-order autoregressive series with mean 0 and variance 1.
inline std::vector<double> autoregressive(std::mt19937_64& random, int length, double rho) {
  std::normal_distribution<double> normal;
  std::vector<double> x(length);
  x[0] = normal(random);
  for (int i = 1; i < length; ++i) x[i] = rho * x[i - 1] + std::sqrt(1.0 - rho * rho) * normal(random);
  return x;
}

/// A fresh folder that goes with its owner.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "softwall-analysis-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace softwall::analysis::samples
