#pragma once

#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "solver/case/bad_input.hpp"
#include "solver/case/case.hpp"

/// Valid documents to start from, and small helpers, for tests.
namespace softwall::tests {

inline nlohmann::json rigid_document() {
  return nlohmann::json::parse(R"({
    "format": 1, "label": "rigid",
    "physics": {"flow": "rigid_channel", "grid": {"nx": 32, "ny_fluid": 24, "nz": 16}},
    "run": {"end_time": 10}})");
}

inline nlohmann::json elastic_document() {
  return nlohmann::json::parse(R"({
    "format": 1, "label": "soft",
    "physics": {"flow": "elastic_wall", "grid": {"nx": 32, "ny_fluid": 32, "ny_solid": 8, "nz": 16},
                "solid": {"G": 0.5}},
    "run": {"end_time": 10}})");
}

/// Every member of a channel written, none with its default.
inline nlohmann::json full_document() {
  return nlohmann::json::parse(R"({
    "format": 1, "label": "full",
    "physics": {
      "flow": "elastic_wall", "reynolds": 3000.5,
      "domain": {"length_x": 7, "length_z": 2.5, "layer_height": 0.75},
      "grid": {"nx": 33, "ny_fluid": 32, "ny_solid": 20, "nz": 17, "stretching": 1.25},
      "precision": "single",
      "solid": {"G": 0.3, "viscosity_ratio": 0.1, "formulation": "reference_map", "weno": "js", "threshold": 0.7,
                "min_eigenvalue": 0.001, "stiffness": "explicit", "mooney_share": 0.25, "dt_plus": 0.2},
      "time_step": {"fixed_dt": 0.001, "safety": 0.5},
      "initial": {"type": "precursor", "amplitude": 0.2, "seed": 7, "precursor": "0123456789abcdef",
                  "precursor_time": 12.5},
      "statistics": {"start_time": 2, "interval_steps": 3, "block_length": 0.25}},
    "run": {"end_time": 11, "checkpoint_steps": 100, "checkpoint_seconds": 30, "keep_checkpoints": 3,
            "field_interval": 0.5, "spectra_steps": 30, "plane_interval": 0.05,
            "planes": {"x": [0, 7], "y": [1, 2.75], "z": [0.5]}, "initial_checkpoint": "../p/checkpoints/checkpoint-000000100.h5"}})");
}

/// What a channel cannot have: every member that only a closed box gives meaning to, none with its default.
inline nlohmann::json box_document() {
  return nlohmann::json::parse(R"({
    "format": 1, "label": "box",
    "physics": {
      "flow": "cavity", "domain": {"length_x": 1, "height": 1.5}, "grid": {"nx": 32, "ny_fluid": 48, "nz": 1},
      "solid": {"G": 0.1, "formulation": "transported_B", "interface": "mthinc", "extension": "normal",
                "disc": {"x": 0.6, "y": 0.5, "radius": 0.2, "slot_width": 0.05, "slot_depth": 0.25}},
      "time_step": {"viscosity": "implicit"}},
    "run": {"end_time": 11}})");
}

/// A wave that belongs to its layers, none of its own members with its default.
inline nlohmann::json wave_document() {
  return nlohmann::json::parse(R"({
    "format": 1, "label": "wave",
    "physics": {
      "flow": "interface_wave", "grid": {"nx": 32, "ny_fluid": 32, "ny_solid": 8, "nz": 1}, "solid": {"G": 1},
      "wave": {"decay": 0.0543952160378, "frequency": 3.09964567747, "displacement": 0.001,
               "mean_flow": "laminar"}},
    "run": {"end_time": 11}})");
}

inline std::string id_of(const nlohmann::json& document) { return parse_case(document.dump()).id; }

/// The message of the BadInput that this raises; empty when it raises none.
template <typename Action>
std::string complaint(Action action) {
  try {
    static_cast<void>(action());
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

inline std::string complaint_about(const nlohmann::json& document) {
  return complaint([&] { return parse_case(document.dump()); });
}

/// An empty folder that goes with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "softwall-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace softwall::tests
