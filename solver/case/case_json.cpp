#include "solver/case/case_json.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "solver/case/case_id.hpp"
#include "solver/case/json_text.hpp"

namespace softwall {
namespace {

using nlohmann::json;

template <typename Enum, std::size_t kCount>
using Names = std::pair<Enum, const char*>[kCount];

constexpr std::pair<FlowType, const char*> kFlowNames[] = {{FlowType::kRigidChannel, "rigid_channel"},
                                                           {FlowType::kElasticWall, "elastic_wall"},
                                                           {FlowType::kCavity, "cavity"},
                                                           {FlowType::kRotation, "rotation"},
                                                           {FlowType::kInterfaceWave, "interface_wave"}};
constexpr std::pair<InitialType, const char*> kInitialNames[] = {
    {InitialType::kPerturbedLaminar, "perturbed_laminar"},
    {InitialType::kPrecursor, "precursor"},
    {InitialType::kNeighbour, "neighbour"}};
constexpr std::pair<SolidFormulation, const char*> kFormulationNames[] = {
    {SolidFormulation::kTransportedB, "transported_B"}, {SolidFormulation::kReferenceMap, "reference_map"}};
constexpr std::pair<WenoWeights, const char*> kWenoNames[] = {{WenoWeights::kJiangShu, "js"},
                                                              {WenoWeights::kZ, "z"}};
constexpr std::pair<InterfaceTransport, const char*> kInterfaceNames[] = {
    {InterfaceTransport::kWeno, "weno"},
    {InterfaceTransport::kMthinc, "mthinc"},
    {InterfaceTransport::kHeight, "height"}};
constexpr std::pair<Extension, const char*> kExtensionNames[] = {{Extension::kColumn, "column"},
                                                                 {Extension::kNormal, "normal"}};
constexpr std::pair<ViscousTerms, const char*> kViscousNames[] = {{ViscousTerms::kExplicit, "explicit"},
                                                                  {ViscousTerms::kImplicit, "implicit"}};

constexpr std::pair<Stiffness, const char*> kStiffnessNames[] = {{Stiffness::kExplicit, "explicit"},
                                                                 {Stiffness::kImplicit, "implicit"}};

constexpr std::pair<MeanFlow, const char*> kMeanFlowNames[] = {{MeanFlow::kNone, "none"},
                                                               {MeanFlow::kLaminar, "laminar"}};

constexpr std::pair<Precision, const char*> kPrecisionNames[] = {{Precision::kDouble, "double"},
                                                                 {Precision::kSingle, "single"}};

template <typename Enum, std::size_t kCount>
std::string name_of(Enum value, const Names<Enum, kCount>& names) {
  return std::find_if(std::begin(names), std::end(names), [&](const auto& one) { return one.first == value; })
      ->second;
}

/// The schema has found that the name is one of these.
template <typename Enum, std::size_t kCount>
Enum named(const json& name, const Names<Enum, kCount>& names) {
  return std::find_if(std::begin(names), std::end(names), [&](const auto& one) { return name == one.second; })
      ->first;
}

GridSpec grid_from(const json& grid) {
  return {grid.at("nx"), grid.at("ny_fluid"), grid.at("ny_solid"), grid.at("nz"), grid.at("stretching")};
}

DiscSpec disc_from(const json& disc) {
  return {disc.at("x"), disc.at("y"), disc.at("radius"), disc.at("slot_width"), disc.at("slot_depth")};
}

SolidSpec solid_from(const json& solid) {
  SolidSpec spec{.G = solid.at("G"),
                 .viscosity_ratio = solid.at("viscosity_ratio"),
                 .formulation = named(solid.at("formulation"), kFormulationNames),
                 .weno = named(solid.at("weno"), kWenoNames),
                 .interface = named(solid.at("interface"), kInterfaceNames),
                 .threshold = solid.at("threshold"),
                 .min_eigenvalue = solid.at("min_eigenvalue"),
                 .mooney_share = solid.at("mooney_share"),
                 .extension = named(solid.at("extension"), kExtensionNames),
                 .stiffness = named(solid.at("stiffness"), kStiffnessNames),
                 .dt_plus = solid.at("dt_plus"),
                 .disc = std::nullopt};
  if (solid.contains("disc")) spec.disc = disc_from(solid.at("disc"));
  return spec;
}

WaveSpec wave_from(const json& wave) {
  return {wave.at("decay"), wave.at("frequency"), wave.at("displacement"),
          named(wave.at("mean_flow"), kMeanFlowNames)};
}

TimeStepSpec time_step_from(const json& time_step) {
  TimeStepSpec spec;
  if (time_step.contains("fixed_dt")) spec.fixed_dt = time_step.at("fixed_dt").get<double>();
  spec.safety = time_step.at("safety");
  spec.viscosity = named(time_step.at("viscosity"), kViscousNames);
  return spec;
}

InitialSpec initial_from(const json& initial) {
  return {named(initial.at("type"), kInitialNames), initial.at("amplitude"), initial.at("seed"),
          initial.at("precursor"), initial.at("precursor_time")};
}

StatisticsSpec statistics_from(const json& statistics) {
  return {statistics.at("start_time"), statistics.at("interval_steps"), statistics.at("block_length")};
}

Physics physics_from(const json& physics) {
  Physics result;
  result.flow = named(physics.at("flow"), kFlowNames);
  result.reynolds = physics.at("reynolds");
  const json& domain = physics.at("domain");
  result.length_x = domain.at("length_x");
  result.length_z = domain.at("length_z");
  result.layer_height = domain.at("layer_height");
  result.height = domain.at("height");
  result.grid = grid_from(physics.at("grid"));
  result.precision = named(physics.at("precision"), kPrecisionNames);
  if (physics.contains("solid")) result.solid = solid_from(physics.at("solid"));
  if (physics.contains("wave")) result.wave = wave_from(physics.at("wave"));
  result.time_step = time_step_from(physics.at("time_step"));
  result.initial = initial_from(physics.at("initial"));
  result.statistics = statistics_from(physics.at("statistics"));
  return result;
}

PlaneSpec planes_from(const json& planes) { return {planes.at("x"), planes.at("y"), planes.at("z")}; }

RunSpec run_from(const json& run) {
  RunSpec result;
  result.end_time = run.at("end_time");
  result.checkpoint_steps = run.at("checkpoint_steps");
  result.checkpoint_seconds = run.at("checkpoint_seconds");
  result.keep_checkpoints = run.at("keep_checkpoints");
  result.field_interval = run.at("field_interval");
  result.spectra_steps = run.at("spectra_steps");
  result.plane_interval = run.at("plane_interval");
  result.planes = planes_from(run.at("planes"));
  result.initial_checkpoint = run.at("initial_checkpoint").get<std::string>();
  return result;
}

json to_json(const GridSpec& grid) {
  return {{"nx", grid.nx},
          {"ny_fluid", grid.ny_fluid},
          {"ny_solid", grid.ny_solid},
          {"nz", grid.nz},
          {"stretching", grid.stretching}};
}

json to_json(const DiscSpec& disc) {
  return {{"x", disc.x},
          {"y", disc.y},
          {"radius", disc.radius},
          {"slot_width", disc.slot_width},
          {"slot_depth", disc.slot_depth}};
}

json to_json(const SolidSpec& solid) {
  json result = {{"G", solid.G},
                 {"viscosity_ratio", solid.viscosity_ratio},
                 {"formulation", name_of(solid.formulation, kFormulationNames)},
                 {"weno", name_of(solid.weno, kWenoNames)},
                 {"interface", name_of(solid.interface, kInterfaceNames)},
                 {"threshold", solid.threshold},
                 {"min_eigenvalue", solid.min_eigenvalue},
                 {"mooney_share", solid.mooney_share},
                 {"extension", name_of(solid.extension, kExtensionNames)},
                 {"stiffness", name_of(solid.stiffness, kStiffnessNames)},
                 {"dt_plus", solid.dt_plus}};
  if (solid.disc) result["disc"] = to_json(*solid.disc);
  return result;
}

json to_json(const WaveSpec& wave) {
  return {{"decay", wave.decay},
          {"frequency", wave.frequency},
          {"displacement", wave.displacement},
          {"mean_flow", name_of(wave.mean_flow, kMeanFlowNames)}};
}

json to_json(const TimeStepSpec& time_step) {
  json result = {{"safety", time_step.safety}, {"viscosity", name_of(time_step.viscosity, kViscousNames)}};
  if (time_step.fixed_dt) result["fixed_dt"] = *time_step.fixed_dt;
  return result;
}

json to_json(const InitialSpec& initial) {
  return {{"type", name_of(initial.type, kInitialNames)},
          {"amplitude", initial.amplitude},
          {"seed", initial.seed},
          {"precursor", initial.precursor},
          {"precursor_time", initial.precursor_time}};
}

json to_json(const StatisticsSpec& statistics) {
  return {{"start_time", statistics.start_time},
          {"interval_steps", statistics.interval_steps},
          {"block_length", statistics.block_length}};
}

json to_json(const Physics& physics) {
  json result = {{"flow", name_of(physics.flow, kFlowNames)},
                 {"reynolds", physics.reynolds},
                 {"domain",
                  {{"length_x", physics.length_x},
                   {"length_z", physics.length_z},
                   {"layer_height", physics.layer_height},
                   {"height", physics.height}}},
                 {"grid", to_json(physics.grid)},
                 {"precision", name_of(physics.precision)},
                 {"time_step", to_json(physics.time_step)},
                 {"initial", to_json(physics.initial)},
                 {"statistics", to_json(physics.statistics)}};
  if (physics.solid) result["solid"] = to_json(*physics.solid);
  if (physics.wave) result["wave"] = to_json(*physics.wave);
  return result;
}

json to_json(const RunSpec& run) {
  return {{"end_time", run.end_time},
          {"checkpoint_steps", run.checkpoint_steps},
          {"checkpoint_seconds", run.checkpoint_seconds},
          {"keep_checkpoints", run.keep_checkpoints},
          {"field_interval", run.field_interval},
          {"spectra_steps", run.spectra_steps},
          {"plane_interval", run.plane_interval},
          {"planes", {{"x", run.planes.x}, {"y", run.planes.y}, {"z", run.planes.z}}},
          {"initial_checkpoint", run.initial_checkpoint.string()}};
}

}  // namespace

std::string name_of(FlowType flow) { return name_of(flow, kFlowNames); }

std::string name_of(Precision precision) { return name_of(precision, kPrecisionNames); }

Case valid_case(const json& filled) {
  return {filled.at("label"), physics_from(filled.at("physics")), run_from(filled.at("run")),
          case_id(filled.at("physics"))};
}

json to_json(const Case& c) {
  return normalised(
      {{"format", 1}, {"label", c.label}, {"physics", to_json(c.physics)}, {"run", to_json(c.run)}});
}

}  // namespace softwall
