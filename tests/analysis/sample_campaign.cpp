/// Writes a campaign folder with the paper's cases, invented but smooth profiles and real files, for the
/// figures: analysis_sample_campaign FOLDER. Prints one JSON line per case: directory, G, viscosity_ratio,
/// derived quantities.
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "analysis/derived.hpp"
#include "samples.hpp"

namespace softwall::analysis {
namespace {

struct Row {
  const char* label;
  double G, ratio;
  samples::ElasticModel model;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows = {
      {"precursor", 0, 1, {2800, 178.5, 178.5, 0.0, 0.0, 0.40, 0.0}},
      {"G=4_mu=1", 4, 1, {2800, 179.0, 180.8, -0.030, 0.011, 0.36, 1.5}},
      {"G=2_mu=1", 2, 1, {2800, 182.1, 203.3, -0.076, 0.069, 0.29, 7.5}},
      {"G=1_mu=1", 1, 1, {2800, 193.0, 240.5, -0.206, 0.120, 0.25, 14.5}},
      {"G=0.5_mu=1", 0.5, 1, {2800, 202.3, 307.0, -0.386, 0.193, 0.20, 24.4}},
      {"G=1_mu=0.1", 1, 0.1, {2800, 192.9, 240.4, -0.197, 0.120, 0.25, 14.5}},
      {"G=1_mu=10", 1, 10, {2800, 187.0, 226.0, -0.127, 0.055, 0.31, 7.9}}};
  return kRows;
}

/// Model profile above its maximum; below, Reichardt's law of the bottom wall, scaled to meet it.
double velocity(const samples::ElasticModel& m, double y) {
  const double top = 1.0 + m.y_max;
  const auto reichardt = [&](double at) {
    const double yp = at * m.re_tau_w;
    return std::log1p(0.4 * yp) / 0.4 + 7.8 * (1.0 - std::exp(-yp / 11.0) - yp / 11.0 * std::exp(-yp / 3.0));
  };
  return y > top ? m.u(y) : m.u_max() * reichardt(y) / reichardt(top);
}

BlockStatistics statistics_of(const Row& row, std::mt19937_64& random) {
  const samples::ElasticModel& m = row.model;
  const int blocks = 24;
  const bool elastic = row.G > 0;
  BlockStatistics s = samples::elastic_statistics(m, blocks, elastic ? 120 : 96);
  s.elastic = elastic;
  if (!elastic) samples::set_uniform_grid(s, 2.0, 96);
  const auto noise = samples::autoregressive(random, blocks, 0.2),
             other = samples::autoregressive(random, blocks, 0.2);
  for (int b = 0; b < blocks; ++b) {
    s.series["wall_shear_bottom"][b] *= 1.0 + 0.02 * noise[b];
    s.series["driving_gradient"][b] *= 1.0 + 0.02 * other[b];
  }
  const auto wall_layer = [&](double y) {
    return y < 2.0 ? (1.0 - std::exp(-12 * y)) : std::exp(-8 * (y - 2.0));
  };
  const auto fluctuation = [&](double level) {
    return [&, level](double y, std::size_t) {
      const double lower = y * std::exp(-y / 0.12) / 0.12,
                   upper = elastic ? 0.15 / row.G * wall_layer(y) : 0.0;
      return std::pow(level * (lower + 0.4 * wall_layer(y) * (y < 2.0 ? 2.0 - y : 0.0) + upper), 2);
    };
  };
  samples::add_profile(s, "u", Location::kCenter,
                       [&](double y, std::size_t b) { return velocity(m, y) * (1.0 + 0.003 * noise[b]); });
  const auto& u = s.profiles["u"].values;
  samples::add_profile(s, "uu", Location::kCenter, fluctuation(0.15));
  for (std::size_t i = 0; i < u.size(); ++i) s.profiles["uu"].values[i] += u[i] * u[i];
  for (const std::string name : {"v", "w"}) {
    samples::add_profile(s, name, Location::kCenter, [](double, std::size_t) { return 0.0; });
    samples::add_profile(s, name + name, Location::kCenter, fluctuation(name == "v" ? 0.05 : 0.07));
  }
  const auto line = [&](double y) { return m.shear_bottom() - m.driving_gradient() * y; };
  const auto viscous = [&](double y) {
    const double below = std::fmax(y - 1e-4, 0.0), above = std::fmin(y + 1e-4, s.y_face.back());
    return (velocity(m, above) - velocity(m, below)) / (above - below) / 2800.0;
  };
  const auto solid = [](double y) { return 0.5 * (1.0 + std::tanh((y - 2.0) / 0.03)); };
  samples::add_profile(s, "viscous_stress", Location::kFace,
                       [&](double y, std::size_t) { return viscous(y); });
  samples::add_profile(s, "uv", Location::kFace, [&](double y, std::size_t) {
    return elastic ? (viscous(y) - line(y)) * (1.0 - solid(y)) : viscous(y) - line(y);
  });
  if (elastic) {
    samples::add_profile(s, "elastic_stress", Location::kFace,
                         [&](double y, std::size_t) { return (line(y) - viscous(y)) * solid(y); });
    for (const char* name : {"v_face", "vv_face", "elastic_xx"})
      s.meanings[name] = {"", "as the solver names it"};
    samples::add_profile(s, "v_face", Location::kFace, [](double, std::size_t) { return 0.0; });
    samples::add_profile(s, "vv_face", Location::kFace, fluctuation(0.05));
    samples::add_profile(s, "phi", Location::kCenter, [&](double y, std::size_t) { return solid(y); });
    samples::add_profile(s, "elastic_xx", Location::kCenter, [&](double y, std::size_t b) {
      return row.G * solid(y) * (1.0 + 0.02 * (y - 2.0) * (1.0 + 0.1 * noise[b]));
    });
  }
  return s;
}

void write_case(const std::filesystem::path& campaign, const Row& row, std::mt19937_64& random) {
  const std::string directory = std::string("cases/") + row.label;
  std::filesystem::create_directories(campaign / directory);
  const BlockStatistics s = statistics_of(row, random);
  write_statistics(campaign / directory / "statistics.h5", s);
  nlohmann::json physics = {
      {"flow", row.G > 0 ? "elastic_wall" : "rigid_channel"},
      {"reynolds", 2800},
      {"grid", {{"nx", 72}, {"ny_fluid", 96}, {"ny_solid", row.G > 0 ? 24 : 0}, {"nz", 64}}}};
  if (row.G > 0) physics["solid"] = {{"G", row.G}, {"viscosity_ratio", row.ratio}};
  std::ofstream(campaign / directory / "case.json") << nlohmann::json{
      {"format", 1}, {"label", row.label}, {"physics", physics}, {"run", {{"end_time", 148}}}};
  const DerivedQuantities derived = derive(s);
  nlohmann::json line = {{"directory", directory}, {"physics", physics}, {"note", derived.note}};
  for (const auto& [name, member] : kMeasuredMembers) {
    const Measured& measured = derived.*member;
    line["quantities"][std::string(name)] = {
        std::isnan(measured.value) ? nlohmann::json() : nlohmann::json(measured.value),
        measured.ci95 ? nlohmann::json(*measured.ci95) : nlohmann::json()};
  }
  line["quantities"]["log_range_low_plus"] = {derived.log_range_low_plus, nullptr};
  line["quantities"]["log_range_high_plus"] = {derived.log_range_high_plus, nullptr};
  std::cout << line << '\n';
}

}  // namespace
}  // namespace softwall::analysis

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: analysis_sample_campaign FOLDER\n";
    return 2;
  }
  std::mt19937_64 random(1);
  for (const auto& row : softwall::analysis::rows()) softwall::analysis::write_case(argv[1], row, random);
  return 0;
}
