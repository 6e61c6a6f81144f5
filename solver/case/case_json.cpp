#include "solver/case/case_json.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "solver/case/case_id.hpp"
#include "solver/case/json_text.hpp"

namespace softwall {
namespace {

using nlohmann::json;

template <typename Enum>
using Names = std::array<std::pair<Enum, const char*>, 2>;

constexpr Names<FlowType> kFlowNames{
    {{FlowType::kRigidChannel, "rigid_channel"}, {FlowType::kElasticWall, "elastic_wall"}}};
constexpr Names<InitialType> kInitialNames{
    {{InitialType::kPerturbedLaminar, "perturbed_laminar"}, {InitialType::kPrecursor, "precursor"}}};
constexpr Names<WenoWeights> kWenoNames{{{WenoWeights::kJiangShu, "js"}, {WenoWeights::kZ, "z"}}};
constexpr Names<Precision> kPrecisionNames{{{Precision::kDouble, "double"}, {Precision::kSingle, "single"}}};

template <typename Enum>
std::string name_of(Enum value, const Names<Enum>& names) {
  return names[0].first == value ? names[0].second : names[1].second;
}

template <typename Enum>
Enum named(const json& name, const Names<Enum>& names) {
  return name == names[0].second ? names[0].first : names[1].first;
}

GridSpec grid_from(const json& grid) {
  return {grid.at("nx"), grid.at("ny_fluid"), grid.at("ny_solid"), grid.at("nz"), grid.at("stretching")};
}

SolidSpec solid_from(const json& solid) {
  return {solid.at("G"), solid.at("viscosity_ratio"), named(solid.at("weno"), kWenoNames),
          solid.at("threshold"), solid.at("min_eigenvalue")};
}

TimeStepSpec time_step_from(const json& time_step) {
  TimeStepSpec spec;
  if (time_step.contains("fixed_dt")) spec.fixed_dt = time_step.at("fixed_dt").get<double>();
  spec.safety = time_step.at("safety");
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
  result.grid = grid_from(physics.at("grid"));
  result.precision = named(physics.at("precision"), kPrecisionNames);
  if (physics.contains("solid")) result.solid = solid_from(physics.at("solid"));
  result.time_step = time_step_from(physics.at("time_step"));
  result.initial = initial_from(physics.at("initial"));
  result.statistics = statistics_from(physics.at("statistics"));
  return result;
}

RunSpec run_from(const json& run) {
  RunSpec result;
  result.end_time = run.at("end_time");
  result.checkpoint_steps = run.at("checkpoint_steps");
  result.checkpoint_seconds = run.at("checkpoint_seconds");
  result.keep_checkpoints = run.at("keep_checkpoints");
  result.field_interval = run.at("field_interval");
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

json to_json(const SolidSpec& solid) {
  return {{"G", solid.G},
          {"viscosity_ratio", solid.viscosity_ratio},
          {"weno", name_of(solid.weno, kWenoNames)},
          {"threshold", solid.threshold},
          {"min_eigenvalue", solid.min_eigenvalue}};
}

json to_json(const TimeStepSpec& time_step) {
  json result = {{"safety", time_step.safety}};
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
                   {"layer_height", physics.layer_height}}},
                 {"grid", to_json(physics.grid)},
                 {"precision", name_of(physics.precision)},
                 {"time_step", to_json(physics.time_step)},
                 {"initial", to_json(physics.initial)},
                 {"statistics", to_json(physics.statistics)}};
  if (physics.solid) result["solid"] = to_json(*physics.solid);
  return result;
}

json to_json(const RunSpec& run) {
  return {{"end_time", run.end_time},
          {"checkpoint_steps", run.checkpoint_steps},
          {"checkpoint_seconds", run.checkpoint_seconds},
          {"keep_checkpoints", run.keep_checkpoints},
          {"field_interval", run.field_interval},
          {"initial_checkpoint", run.initial_checkpoint.string()}};
}

}  // namespace

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
