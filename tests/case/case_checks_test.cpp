#include <gtest/gtest.h>

#include "tests/case/examples.hpp"

namespace softwall {
namespace {

using nlohmann::json;
using tests::complaint_about;

json with(json document, const char* pointer, const json& value) {
  document[json::json_pointer(pointer)] = value;
  return document;
}

json elastic_with(const char* pointer, const json& value) {
  return with(tests::elastic_document(), pointer, value);
}

void expect_complaint(const json& document, const std::string& part) {
  const std::string message = complaint_about(document);
  EXPECT_NE(message.find(part), std::string::npos) << "got: " << message;
}

TEST(CaseChecks, AnElasticWallNeedsItsSolid) {
  json document = tests::elastic_document();
  document["physics"].erase("solid");
  expect_complaint(document, "/physics/solid: missing");
  expect_complaint(elastic_with("/physics/grid/ny_solid", 3),
                   "/physics/grid/ny_solid: 3; an elastic wall needs at least 4");
}

TEST(CaseChecks, OnlyATransportedFractionHasASharpInterface) {
  json document = elastic_with("/physics/solid/interface", "mthinc");
  document["physics"]["solid"]["formulation"] = "transported_B";
  EXPECT_EQ(complaint_about(document), "");
  document["physics"]["solid"]["formulation"] = "reference_map";
  expect_complaint(document, "/physics/solid/interface: mthinc");
}

TEST(CaseChecks, AHeightOverEachColumnNeedsALayer) {
  json document = elastic_with("/physics/solid/formulation", "transported_B");
  EXPECT_EQ(complaint_about(document), "");
  document["physics"]["solid"]["extension"] = "normal";
  expect_complaint(document, "/physics/solid/interface: height");
  document = tests::box_document();
  document["physics"]["solid"].erase("interface");
  expect_complaint(document, "/physics/solid/interface: height; must be \"mthinc\" or \"weno\" with a disc");
}

TEST(CaseChecks, StepsOfAnElasticWallAloneAreHeldToViscousTimes) {
  EXPECT_EQ(complaint_about(elastic_with("/physics/solid/dt_plus", 0.2)), "");
  json document = tests::box_document();
  document["physics"]["solid"]["dt_plus"] = 0.2;
  expect_complaint(document, "/physics/solid/dt_plus: given; limits the steps of flow \"elastic_wall\" only");
}

TEST(CaseChecks, PlanesLieInTheBox) {
  for (const auto& [flow, axis, inside, beyond] :
       {std::tuple("rigid", "x", 6.0, 6.01), std::tuple("rigid", "y", 2.0, 2.01),
        std::tuple("rigid", "z", 3.0, 3.01), std::tuple("elastic", "y", 2.5, 2.51)}) {
    json document = flow == std::string("rigid") ? tests::rigid_document() : tests::elastic_document();
    document["run"]["planes"][axis] = {0, inside};
    EXPECT_EQ(complaint_about(document), "");
    document["run"]["planes"][axis] = {0, inside, beyond};
    expect_complaint(document, std::string("/run/planes/") + axis + "/2: " + json(beyond).dump() +
                                   "; beyond the end of the box at " + axis + " = ");
  }
  json box = tests::box_document();
  box["run"]["planes"] = {{"y", {1.6}}};
  expect_complaint(box, "/run/planes/y/0: 1.6; beyond the end of the box at y = 1.5 h");
}

TEST(CaseChecks, PlanesAreListsOfNumbers) {
  json document = tests::rigid_document();
  const auto complaint_of = [&](const json& planes) {
    document["run"]["planes"] = planes;
    return complaint_about(document);
  };
  for (const json& none : {json::object(), json({{"x", json::array()}})}) EXPECT_EQ(complaint_of(none), "");
  EXPECT_NE(complaint_of({{"x", 1}}).find("/run/planes/x: 1; must be an array"), std::string::npos);
  EXPECT_NE(complaint_of({{"z", {1, "2"}}}).find("/run/planes/z/1: \"2\""), std::string::npos);
  EXPECT_NE(complaint_of({{"y", {-0.1}}}).find("/run/planes/y/0: -0.1; must be a number from 0"),
            std::string::npos);
  EXPECT_NE(complaint_of({{"r", {1}}}).find("/run/planes/r: unknown key"), std::string::npos);
  EXPECT_NE(complaint_of({{"x", std::vector<double>(101, 1.0)}}).find("at most 100 members"),
            std::string::npos);
}

TEST(CaseChecks, ARigidChannelHasNone) {
  json document = tests::rigid_document();
  document["physics"]["solid"] = {{"G", 1}};
  document["physics"]["grid"]["ny_solid"] = 8;
  expect_complaint(document, "/physics/solid: given");
  expect_complaint(document, "/physics/grid/ny_solid: 8; must be 0");
}

json box_with(const char* pointer, const json& value) { return with(tests::box_document(), pointer, value); }

TEST(CaseChecks, AClosedBoxIsFlatAndUniform) {
  EXPECT_EQ(complaint_about(tests::box_document()), "");
  expect_complaint(box_with("/physics/grid/nz", 4), "/physics/grid/nz: 4; must be 1");
  expect_complaint(box_with("/physics/grid/stretching", 1), "/physics/grid/stretching");
  expect_complaint(box_with("/physics/grid/ny_solid", 4), "/physics/grid/ny_solid: 4; must be 0");
  expect_complaint(box_with("/physics/initial", {{"type", "precursor"}, {"precursor", "0123456789abcdef"}}),
                   "/physics/initial/type: precursor");
}

TEST(CaseChecks, TheSolidOfAClosedBoxIsADiscAwayFromTheWalls) {
  expect_complaint(box_with("/physics/solid", {{"G", 1}, {"extension", "normal"}}),
                   "/physics/solid/disc: missing");
  expect_complaint(box_with("/physics/solid/disc/x", 0.79), "/physics/solid/disc: touches a wall");
  expect_complaint(box_with("/physics/solid/disc/y", 0.21), "/physics/solid/disc: touches a wall");
  expect_complaint(box_with("/physics/solid/extension", "column"), "/physics/solid/extension: column");
  expect_complaint(box_with("/physics/solid/formulation", "reference_map"),
                   "/physics/solid/formulation: reference_map");
  json fluid = tests::box_document();
  fluid["physics"].erase("solid");
  EXPECT_EQ(complaint_about(fluid), "");
  fluid["physics"]["flow"] = "rotation";
  expect_complaint(fluid, "/physics/solid/disc: missing");
}

TEST(CaseChecks, ImplicitViscosityNeedsABoxOfOneViscosity) {
  expect_complaint(box_with("/physics/solid/viscosity_ratio", 2), "/physics/time_step/viscosity: implicit");
  expect_complaint(elastic_with("/physics/time_step/viscosity", "implicit"),
                   "must be \"explicit\" in a channel");
}

TEST(CaseChecks, AChannelIsNoBox) {
  expect_complaint(elastic_with("/physics/domain/height", 1), "/physics/domain/height");
  expect_complaint(elastic_with("/physics/solid/disc", {{"x", 1}, {"y", 1}, {"radius", 0.2}}),
                   "/physics/solid/disc: given");
}

json wave_with(const char* pointer, const json& value) {
  return with(tests::wave_document(), pointer, value);
}

TEST(CaseChecks, AWaveNeedsItsLayerAndItsRate) {
  EXPECT_EQ(complaint_about(tests::wave_document()), "");
  json document = tests::wave_document();
  document["physics"].erase("wave");
  expect_complaint(document, "/physics/wave: missing; flow \"interface_wave\" needs");
  document["physics"].erase("solid");
  expect_complaint(document, "/physics/solid: missing; flow \"interface_wave\" needs");
  document = tests::wave_document();
  document["physics"]["wave"].erase("frequency");
  expect_complaint(document, "/physics/wave/frequency: missing");
  expect_complaint(wave_with("/physics/grid/ny_solid", 9), "ny_solid must be 8");
  expect_complaint(wave_with("/physics/time_step/viscosity", "implicit"),
                   "must be \"explicit\" in a channel");
  expect_complaint(wave_with("/physics/initial", {{"type", "precursor"}, {"precursor", "0123456789abcdef"}}),
                   "an interface wave starts by itself");
}

/// The message says what would be right, and that is then accepted.
TEST(CaseChecks, TheRateOfAWaveIsOneOfItsLayers) {
  const json rough = wave_with("/physics/wave", {{"decay", 0.05}, {"frequency", 3}});
  expect_complaint(rough, "/physics/wave: decay 0.05, frequency 3; not the rate of a wave of these layers");
  expect_complaint(rough, "the nearest one found: decay 0.05439521604, frequency 3.099645677");
  EXPECT_EQ(
      complaint_about(wave_with("/physics/wave", {{"decay", 0.05439521604}, {"frequency", 3.099645677}})),
      "");
  expect_complaint(wave_with("/physics/solid/G", 1.001), "not the rate of a wave");
  expect_complaint(wave_with("/physics/solid/viscosity_ratio", 1.1), "not the rate of a wave");
  expect_complaint(wave_with("/physics/reynolds", 2900), "not the rate of a wave");
  expect_complaint(wave_with("/physics/domain/length_x", 6.1), "not the rate of a wave");
}

TEST(CaseChecks, OnlyAnInterfaceWaveHasOne) {
  for (json document : {tests::elastic_document(), tests::rigid_document(), tests::box_document()}) {
    document["physics"]["wave"] = {{"decay", 1}, {"frequency", 1}};
    expect_complaint(document, "/physics/wave: given; only flow \"interface_wave\" has one");
  }
}

TEST(CaseChecks, UniformSpacingMustMatch) {
  expect_complaint(elastic_with("/physics/grid/ny_solid", 9), "ny_solid must be 8");
  expect_complaint(elastic_with("/physics/domain/layer_height", 0.51), "no ny_solid fits");
  expect_complaint(elastic_with("/physics/grid/ny_fluid", 8), "ny_fluid must be 16 or more");
  json thirds = elastic_with("/physics/domain/layer_height", 1.0 / 3.0);
  thirds["physics"]["grid"]["ny_fluid"] = 30;
  thirds["physics"]["grid"]["ny_solid"] = 5;
  EXPECT_EQ(complaint_about(thirds), "");
}

/// Whatever the message recommends is then accepted.
TEST(CaseChecks, AdviceForStretchedGridsIsRight) {
  for (const double stretching : {0.5, 1.0, 1.8, 2.5}) {
    json document = elastic_with("/physics/grid/stretching", stretching);
    document["physics"]["grid"]["ny_solid"] = 90000;
    const std::string message = complaint_about(document);
    const std::size_t from = message.find("ny_solid from ");
    ASSERT_NE(from, std::string::npos) << message;
    int least = 0, most = 0;
    ASSERT_EQ(std::sscanf(message.c_str() + from, "ny_solid from %d to %d", &least, &most), 2);
    for (const auto& [cells, works] :
         {std::pair{least - 1, false}, {least, true}, {most, true}, {most + 1, false}}) {
      if (cells < 4) continue;
      document["physics"]["grid"]["ny_solid"] = cells;
      EXPECT_EQ(complaint_about(document).empty(), works)
          << stretching << " " << cells << complaint_about(document);
    }
  }
}

TEST(CaseChecks, APrecursorMustBeNamed) {
  expect_complaint(elastic_with("/physics/initial/type", "precursor"), "/physics/initial/precursor: empty");
}

TEST(CaseChecks, ComeTogetherWithTheSchemasMistakes) {
  json document = elastic_with("/physics/grid/ny_solid", 9);
  document["physics"]["initial"]["type"] = "precursor";
  document["physics"]["solid"]["G"] = -1;
  document["run"]["end_tim"] = 1;
  const std::string message = complaint_about(document);
  for (const char* place : {"/physics/grid/ny_solid: 9", "/physics/initial/precursor: empty",
                            "/physics/solid/G: -1", "/run/end_tim: unknown key"})
    EXPECT_NE(message.find(place), std::string::npos) << message;
}

TEST(CaseChecks, DeriveNothingFromWhatIsWrong) {
  json document = elastic_with("/physics/grid/ny_solid", 9);
  document["physics"]["grid"]["ny_fluid"] = "many";
  EXPECT_EQ(complaint_about(document).find("/physics/grid/ny_solid"), std::string::npos)
      << complaint_about(document);
}

}  // namespace
}  // namespace softwall
