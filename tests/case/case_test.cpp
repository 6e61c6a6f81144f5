#include "solver/case/case.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "solver/case/case_schema.hpp"
#include "tests/case/examples.hpp"

namespace softwall {
namespace {

using nlohmann::json;

TEST(Case, EveryMemberArrives) {
  const Case c = parse_case(tests::full_document().dump());
  EXPECT_EQ(c.label, "full");
  const Physics& p = c.physics;
  EXPECT_EQ(p.flow, FlowType::kElasticWall);
  EXPECT_EQ(p.reynolds, 3000.5);
  EXPECT_EQ(p.length_x, 7.0);
  EXPECT_EQ(p.length_z, 2.5);
  EXPECT_EQ(p.layer_height, 0.75);
  EXPECT_EQ(p.grid.nx, 33);
  EXPECT_EQ(p.grid.ny_fluid, 32);
  EXPECT_EQ(p.grid.ny_solid, 20);
  EXPECT_EQ(p.grid.ny(), 52);
  EXPECT_EQ(p.grid.nz, 17);
  EXPECT_EQ(p.grid.stretching, 1.25);
  EXPECT_EQ(p.precision, Precision::kSingle);
  ASSERT_TRUE(p.solid);
  EXPECT_EQ(p.solid->G, 0.3);
  EXPECT_EQ(p.solid->viscosity_ratio, 0.1);
  EXPECT_EQ(p.solid->formulation, SolidFormulation::kReferenceMap);
  EXPECT_EQ(p.solid->weno, WenoWeights::kJiangShu);
  EXPECT_EQ(p.solid->threshold, 0.7);
  EXPECT_EQ(p.solid->min_eigenvalue, 0.001);
  EXPECT_EQ(p.time_step.fixed_dt, 0.001);
  EXPECT_EQ(p.time_step.safety, 0.5);
  EXPECT_EQ(p.initial.type, InitialType::kPrecursor);
  EXPECT_EQ(p.initial.amplitude, 0.2);
  EXPECT_EQ(p.initial.seed, 7U);
  EXPECT_EQ(p.initial.precursor, "0123456789abcdef");
  EXPECT_EQ(p.initial.precursor_time, 12.5);
  EXPECT_EQ(p.statistics.start_time, 2.0);
  EXPECT_EQ(p.statistics.interval_steps, 3);
  EXPECT_EQ(p.statistics.block_length, 0.25);
  EXPECT_EQ(c.run.end_time, 11.0);
  EXPECT_EQ(c.run.checkpoint_steps, 100);
  EXPECT_EQ(c.run.checkpoint_seconds, 30.0);
  EXPECT_EQ(c.run.keep_checkpoints, 3);
  EXPECT_EQ(c.run.field_interval, 0.5);
  EXPECT_EQ(c.run.plane_interval, 0.05);
  EXPECT_EQ(c.run.planes.x, (std::vector<double>{0, 7}));
  EXPECT_EQ(c.run.planes.y, (std::vector<double>{1, 2.75}));
  EXPECT_EQ(c.run.planes.z, (std::vector<double>{0.5}));
  EXPECT_EQ(c.run.initial_checkpoint, "../p/checkpoints/checkpoint-000000100.h5");
  EXPECT_EQ(c.id.size(), 16U);
}

TEST(Case, WritingAndReadingBackChangesNothing) {
  for (const json& document : {tests::rigid_document(), tests::elastic_document(), tests::full_document(),
                               tests::box_document(), tests::wave_document()}) {
    const Case c = parse_case(document.dump());
    const json written = to_json(c);
    const Case again = parse_case(written.dump());
    EXPECT_EQ(to_json(again), written);
    EXPECT_EQ(again.id, c.id);
  }
  json full = tests::full_document();
  case_schema().fill_defaults(full);  // what only a closed box has
  EXPECT_EQ(to_json(parse_case(full.dump())), full);
}

TEST(Case, WhatCarriesPhiIsRead) {
  EXPECT_EQ(parse_case(tests::elastic_document().dump()).physics.solid->interface,
            InterfaceTransport::kHeight);
  EXPECT_EQ(parse_case(tests::box_document().dump()).physics.solid->interface, InterfaceTransport::kMthinc);
}

TEST(Case, AWaveIsRead) {
  const Physics p = parse_case(tests::wave_document().dump()).physics;
  EXPECT_EQ(p.flow, FlowType::kInterfaceWave);
  ASSERT_TRUE(p.wave);
  EXPECT_EQ(p.wave->decay, 0.0543952160378);
  EXPECT_EQ(p.wave->frequency, 3.09964567747);
  EXPECT_EQ(p.wave->displacement, 0.001);
  EXPECT_EQ(p.wave->mean_flow, MeanFlow::kLaminar);
  EXPECT_TRUE(p.is_driven());
  EXPECT_FALSE(parse_case(tests::elastic_document().dump()).physics.wave);
}

TEST(Case, AWaveOverFluidAtRestIsNotDriven) {
  json document = tests::wave_document();
  document["physics"]["wave"].erase("mean_flow");
  const Physics p = parse_case(document.dump()).physics;
  EXPECT_EQ(p.wave->mean_flow, MeanFlow::kNone);
  EXPECT_FALSE(p.is_driven());
}

TEST(Case, NumbersSurviveToTheLastBit) {
  for (const double value : {0.1, 1.0 / 3.0, 2.0 / 7.0 * 1e-300, 1e300, 5e-324}) {
    json document = tests::elastic_document();
    document["physics"]["solid"]["G"] = value;
    EXPECT_EQ(parse_case(to_json(parse_case(document.dump())).dump()).physics.solid->G, value);
  }
}

TEST(Case, MessagesNameTheFile) {
  const tests::TemporaryFolder folder;
  const auto file = folder / "case.json";
  std::ofstream(file) << "{\"format\": 2}";
  const std::string message = tests::complaint([&] { return read_case(file); });
  EXPECT_TRUE(message.starts_with(file.string() + ":\n")) << message;
  EXPECT_NE(message.find("/format: 2; must be 1"), std::string::npos) << message;
  EXPECT_NE(message.find("/physics: missing"), std::string::npos) << message;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);  // nothing created
}

}  // namespace
}  // namespace softwall
