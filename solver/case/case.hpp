#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

/// A case as the solver and the manager see it. Every field mirrors schemas/case.schema.json, where type,
/// unit, default and meaning are written; defaults stand nowhere else. Units: half height h, bulk velocity
/// U_b, density rho.
namespace softwall {

enum class FlowType { kRigidChannel, kElasticWall, kCavity, kRotation, kInterfaceWave };

/// A closed box has walls at both ends of x and y and is driven by one of them or not at all. All other flows
/// are channels.
[[nodiscard]] constexpr bool is_closed_box(FlowType flow) {
  return flow == FlowType::kCavity || flow == FlowType::kRotation;
}

/// A channel that a pressure gradient drives at constant flow rate, and whose statistics are those of a
/// turbulent one.
[[nodiscard]] constexpr bool is_driven_channel(FlowType flow) {
  return flow == FlowType::kRigidChannel || flow == FlowType::kElasticWall;
}

enum class InitialType { kPerturbedLaminar, kPrecursor, kNeighbour };
enum class SolidFormulation { kTransportedB, kReferenceMap };
enum class WenoWeights { kJiangShu, kZ };
enum class InterfaceTransport { kWeno, kMthinc, kHeight };
enum class Precision { kDouble, kSingle };
enum class Extension { kColumn, kNormal };
enum class ViscousTerms { kExplicit, kImplicit };
enum class Stiffness { kExplicit, kImplicit };
enum class MeanFlow { kNone, kLaminar };

struct GridSpec {
  int nx = 0;
  int ny_fluid = 0;  ///< cells in 0 < y < 2, or in the height of a closed box
  int ny_solid = 0;  ///< cells in 2 < y < 2 + layer_height; 0 for a rigid channel
  int nz = 0;
  double stretching = 0.0;  ///< 0: uniform; s > 0: y = 1 + tanh(s (2 xi - 1)) / tanh(s) in the fluid
  [[nodiscard]] int ny() const { return ny_fluid + ny_solid; }
};

/// A disc, perhaps slotted from below.
struct DiscSpec {
  double x = 0.0, y = 0.0, radius = 0.0;
  double slot_width = 0.0, slot_depth = 0.0;
};

/// It has no defaults, so that whoever makes one has to name every member.
struct SolidSpec {
  double G;                ///< modulus of transverse elasticity / (rho U_b^2)
  double viscosity_ratio;  ///< mu_s / mu_f
  SolidFormulation formulation;
  WenoWeights weno;
  InterfaceTransport interface;
  double threshold;       ///< cells with phi below it take B from the solid, as `extension` says
  double min_eigenvalue;  ///< B is kept >= this in every cell
  double mooney_share;    ///< c2 / G of the Mooney-Rivlin law (elastic_law.hpp); 0: neo-Hookean
  Extension extension;
  Stiffness stiffness;           ///< how the stress across thin rows enters the time step
  double dt_plus;                ///< largest step of a driven channel, nu / u_tau^2; 0: what is stable
  std::optional<DiscSpec> disc;  ///< initial shape in a closed box; absent: the layer on y > 2
};

/// The mode of linear theory (interface_mode.hpp) that an interface wave starts as.
struct WaveSpec {
  double decay = 0.0, frequency = 0.0;  ///< its rate is -decay + i frequency, U_b / h
  double displacement = 0.0;            ///< of the crest of the interface, h
  MeanFlow mean_flow = MeanFlow::kNone;
};

struct TimeStepSpec {
  std::optional<double> fixed_dt;  ///< when absent: adaptive
  double safety = 0.0;             ///< fraction of the stability limits
  ViscousTerms viscosity = ViscousTerms::kExplicit;
};

struct InitialSpec {
  InitialType type = InitialType::kPerturbedLaminar;
  double amplitude = 0.0;  ///< of the perturbation, in U_b
  std::uint64_t seed = 0;
  std::string precursor;      ///< case id whose last checkpoint starts this case
  double precursor_time = 0;  ///< the end time that case ran to
};

struct StatisticsSpec {
  double start_time = 0.0;
  int interval_steps = 0;     ///< steps between samples
  double block_length = 0.0;  ///< h/U_b per statistics block
};

/// What makes two runs the same physical case: all of it, and nothing else, enters the case id.
struct Physics {
  FlowType flow = FlowType::kRigidChannel;
  double reynolds = 0.0;
  double length_x = 0.0, length_z = 0.0, layer_height = 0.0;
  double height = 2.0;  ///< of a closed box; a channel's fluid is 2 high
  GridSpec grid;
  Precision precision = Precision::kDouble;  ///< of the fields
  std::optional<SolidSpec> solid;            ///< present with an elastic wall or a disc
  std::optional<WaveSpec> wave;              ///< of an interface wave
  TimeStepSpec time_step;
  InitialSpec initial;
  StatisticsSpec statistics;

  /// Whether a pressure gradient holds its flow rate.
  [[nodiscard]] bool is_driven() const {
    return is_driven_channel(flow) || (wave && wave->mean_flow == MeanFlow::kLaminar);
  }
};

/// Where the planes of a film lie, h; each is the plane of cells whose centres are nearest.
struct PlaneSpec {
  std::vector<double> x, y, z;
};

/// How far and how to run it; may change between attempts without changing any number computed.
struct RunSpec {
  double end_time = 0.0;
  std::int64_t checkpoint_steps = 0;  ///< steps between checkpoints; 0: by wall clock only
  double checkpoint_seconds = 0.0;    ///< wall-clock seconds between checkpoints; 0: by steps only
  int keep_checkpoints = 2;
  double field_interval = 0.0;               ///< h/U_b between field snapshots for ParaView; 0: none
  std::int64_t spectra_steps = 0;            ///< steps between samples of spectra; 0: none
  double plane_interval = 0.0;               ///< h/U_b between moments of a film; 0: none
  PlaneSpec planes;                          ///< in a film
  std::filesystem::path initial_checkpoint;  ///< precursor's checkpoint file; relative to the run directory
};

struct Case {
  std::string label;
  Physics physics;
  RunSpec run;
  std::string id;  ///< case_id(physics), 16 hexadecimal digits
};

/// "elastic_wall" and its like, as in a case.
[[nodiscard]] std::string name_of(FlowType flow);

/// "double" or "single", as in a case and in the header of a checkpoint.
[[nodiscard]] std::string name_of(Precision precision);

/// Parse and check a case.json text. Throws BadInput (bad_input.hpp) with every mistake.
[[nodiscard]] Case parse_case(const std::string& text);
[[nodiscard]] Case read_case(const std::filesystem::path& case_file);

/// The whole case as JSON with every default written out; parse_case(to_json(c).dump()) == c.
[[nodiscard]] nlohmann::json to_json(const Case& c);

}  // namespace softwall
