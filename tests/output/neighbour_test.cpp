#include "solver/output/neighbour.hpp"

#include <gtest/gtest.h>

#include "solver/output/agree.hpp"
#include "solver/time/advance.hpp"
#include "tests/output/sample_state.hpp"
#include "tests/output/shared_folder.hpp"
#include "tests/support/order.hpp"

namespace softwall::output {
namespace {

using support::kCaseId;

class NeighbourTest : public testing::Test {
 protected:
  parallel::Communicator world_ = parallel::Communicator::duplicate(MPI_COMM_WORLD);
  support::SharedFolder folder_{world_};
  RunFiles run_{folder_.path()};

  static Physics wall(SolidFormulation formulation, double G) {
    Physics physics = support::elastic_channel({12, 8, 4, 14});
    physics.solid->formulation = formulation;
    physics.solid->G = G;
    return physics;
  }
  std::filesystem::path write(time::State& state, const time::Setup& setup) {
    return write_checkpoint(run_, {kCaseId, 0}, state, support::sample_record(), setup);
  }
  static InitialSpec initial(double time = 0) {
    return {.type = InitialType::kNeighbour, .precursor = kCaseId, .precursor_time = time};
  }
  /// What is said against a start of this case from the file.
  std::string refusal(const std::filesystem::path& file, const InitialSpec& from, const Physics& physics) {
    time::Setup setup(physics, world_.get());
    try {
      static_cast<void>(start_from_neighbour(file, from, setup));
    } catch (const AgreedError& error) {
      EXPECT_EQ(error.code, ExitCode::kBadCase) << error.what();
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(NeighbourTest, EveryFieldIsCarriedOverAndTimeBeginsAnew) {
  for (const auto formulation : {SolidFormulation::kReferenceMap, SolidFormulation::kTransportedB}) {
    time::Setup source(wall(formulation, 2), world_.get());
    time::State end = support::numbered_state(source, 20);
    time::start(end, source);  // walls at rest, B as it may be: what a step would have left
    const auto file = write(end, source);
    Physics softer = wall(formulation, 0.5);
    softer.solid->viscosity_ratio = 10;
    time::Setup target(softer, world_.get());
    time::State start = start_from_neighbour(file, initial(2), target);
    EXPECT_EQ(start.step, 0);
    EXPECT_EQ(start.time, 0);
    EXPECT_EQ(start.driving_gradient, end.driving_gradient);
    const auto before = support::all_fields(end, source), now = support::all_fields(start, target);
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_EQ(support::largest_difference(before[i], now[i]), 0.0) << time::fields_of(start)[i].name;
  }
}

TEST_F(NeighbourTest, AnotherGridFormulationCaseOrTimeIsRefused) {
  time::Setup source(wall(SolidFormulation::kReferenceMap, 2), world_.get());
  time::State end = support::numbered_state(source, 20);
  const auto file = write(end, source);
  const Physics same = wall(SolidFormulation::kReferenceMap, 1);
  Physics finer = same;
  finer.grid.nx = 16;
  EXPECT_NE(refusal(file, initial(2), finer).find("is 12 x 12 x 14, this case has 16 x 12 x 14"),
            std::string::npos);
  Physics stretched = same;
  stretched.grid.stretching += 0.1;
  EXPECT_NE(refusal(file, initial(2), stretched).find("height of a cell face"), std::string::npos);
  const std::string other_solid = refusal(file, initial(2), wall(SolidFormulation::kTransportedB, 1));
  EXPECT_NE(other_solid.find("same grid, precision and solid.formulation"), std::string::npos);
  EXPECT_NE(other_solid.find("fields/phi"), std::string::npos) << other_solid;
  EXPECT_NE(refusal(file, initial(3), same).find("where the neighbour has come to 3"), std::string::npos);
  InitialSpec other = initial(2);
  other.precursor = "ffffffffffffffff";
  EXPECT_NE(refusal(file, other, same).find("belongs to case 0123456789abcdef"), std::string::npos);
  EXPECT_NE(refusal(folder_.path() / "none.h5", initial(2), same).find("does not exist"), std::string::npos);
}

}  // namespace
}  // namespace softwall::output
