#include "solver/statistics/energy_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/statistics/flows.hpp"

namespace softwall::statistics {
namespace {

using namespace testing;

/// A sample by name.
class Budget {
 public:
  Budget(const time::State& s, time::Setup& setup) : grid_(setup.grid) {
    EnergyBudget budget(setup.grid);
    EXPECT_FALSE(budget.sample(s, setup, 0));
    values_ = budget.sample(s, setup, 1).value();
  }
  [[nodiscard]] double operator()(std::string_view name, int j) const {
    const auto kind = std::ranges::find(kBudgetKinds, name, &BudgetKind::name) - kBudgetKinds.begin();
    return values_.at(static_cast<std::size_t>(kind * grid_.ny + j));
  }
  /// Integral over the height.
  [[nodiscard]] double total(std::string_view name) const {
    double sum = 0;
    for (int j = 0; j < grid_.ny; ++j) sum += (*this)(name, j) * grid_.dy[j];
    return sum;
  }
  /// What all terms say of the rate of change of the kinetic energy in a row.
  [[nodiscard]] double rate(int j) const {
    double sum = 0;
    for (const auto& kind : kBudgetKinds)
      if (kind.name.starts_with("power_")) sum += (*this)(kind.name, j);
    return sum;
  }

 private:
  const grid::Grid& grid_;
  std::vector<double> values_;
};

/// A rigid channel, and a layer of another viscosity in every formulation and with every treatment of its
/// stress.
std::vector<Physics> flows() {
  std::vector<Physics> all{rigid_case(), elastic_case(), elastic_case(), elastic_case(), elastic_case()};
  all[2].solid->formulation = SolidFormulation::kReferenceMap;
  all[3].solid->formulation = SolidFormulation::kReferenceMap;
  all[3].solid->stiffness = Stiffness::kImplicit;
  all[4].solid->viscosity_ratio = 1;
  all[4].solid->formulation = SolidFormulation::kReferenceMap;
  all[4].solid->mooney_share = 0.3;
  for (Physics& p : all) p.grid.stretching = 1;
  return all;
}

/// A disturbed flow after some steps of this length.
time::State developed(time::Setup& setup, double dt, int steps) {
  auto s = time::perturbed_laminar(setup);
  for (int n = 0; n < steps; ++n) time::advance(s, setup, dt);
  return s;
}

TEST(EnergyBudget, NothingIsLostOnTheWay) {
  for (const Physics& physics : flows()) {
    time::Setup setup(physics, MPI_COMM_WORLD);
    const Budget budget(developed(setup, 0.004, 25), setup);
    const double bar = 1e-12 * budget.total("work_viscous");
    EXPECT_NEAR(budget.total("power_convection"), 0, bar);
    EXPECT_NEAR(budget.total("power_pressure"), 0, bar);
    EXPECT_NEAR(budget.total("power_viscous"), -budget.total("work_viscous"), bar);
    EXPECT_NEAR(budget.total("power_excess"), -budget.total("work_excess"), bar);
    EXPECT_NEAR(budget.total("power_elastic"), -budget.total("work_elastic"), bar);
    EXPECT_GT(budget.total("work_viscous"), 0);
    if (!physics.solid) continue;
    EXPECT_GT(std::abs(budget.total("work_elastic")), 100 * bar);
    EXPECT_GT(budget.total("elastic"), 0);
    EXPECT_GT(std::abs(budget.total("work_excess")), 100 * bar);
  }
}

/// The terms of each row add up to what a short step changes there.
TEST(EnergyBudget, TermsAddUpToTheRateOfChange) {
  for (const Physics& physics : flows()) {
    time::Setup setup(physics, MPI_COMM_WORLD);
    constexpr double kStep = 2e-5;
    auto s = developed(setup, 0.004, 25);
    for (int n = 0; n < 3; ++n) time::advance(s, setup, kStep);
    const Budget before(s, setup);
    time::advance(s, setup, kStep);
    const Budget after(s, setup);
    double largest = 0;
    for (int j = 0; j < setup.grid.ny; ++j) {
      for (const auto& kind : kBudgetKinds)
        if (kind.name.starts_with("power_")) largest = std::max(largest, std::abs(before(kind.name, j)));
    }
    for (int j = 0; j < setup.grid.ny; ++j) {
      const double change = (after("kinetic", j) - before("kinetic", j)) / kStep;
      EXPECT_NEAR((before.rate(j) + after.rate(j)) / 2, change, 2e-4 * largest) << j;
    }
  }
}

/// A step leaves the pressure of its last substep, which is a little older than the velocity.
TEST(EnergyBudget, HasThePressureOfTheMomentNotOfTheStep) {
  for (const Physics& physics : flows()) {
    time::Setup setup(physics, MPI_COMM_WORLD);
    auto s = developed(setup, 0.004, 5);
    const Budget budget(s, setup);
    s.pressure = grid::Field(setup.grid, 1, grid::Memory::kByPlane);
    const Budget without(s, setup);
    double largest = 0;
    for (int j = 0; j < setup.grid.ny; ++j) {
      EXPECT_EQ(without("power_pressure", j), budget("power_pressure", j)) << j;
      largest = std::max(largest, std::abs(budget("power_pressure", j)));
    }
    EXPECT_GT(largest, 0);
  }
}

/// Rates are those of all the time since the sample before, so that their means lose nothing between samples,
/// in a budget that goes on from another as well.
TEST(EnergyBudget, RatesAreChangesSinceTheSampleBefore) {
  time::Setup setup(flows()[1], MPI_COMM_WORLD);
  auto s = developed(setup, 0.004, 5);
  EnergyBudget first(setup.grid), second(setup.grid);
  ASSERT_FALSE(first.sample(s, setup, 0));
  const std::vector<double> start = first.before();
  const double started = s.time;
  for (int n = 0; n < 3; ++n) time::advance(s, setup, 0.004);
  second.continue_from(start);
  const auto values = second.sample(s, setup, s.time - started);
  ASSERT_TRUE(values);
  const std::vector<double>& end = second.before();
  const auto rates = values->end() - static_cast<std::ptrdiff_t>(end.size());
  for (std::size_t n = 0; n < end.size(); ++n)
    EXPECT_DOUBLE_EQ(rates[static_cast<std::ptrdiff_t>(n)], (end[n] - start[n]) / (s.time - started)) << n;
  EXPECT_EQ(first.sample(s, setup, s.time - started), values);
  EXPECT_THROW(second.continue_from(std::span(start).first(start.size() - 1)), std::runtime_error);
}

TEST(EnergyBudget, ForcesAreTheDifferencesOfTheStresses) {
  time::Setup setup(flows()[1], MPI_COMM_WORLD);
  const auto& g = setup.grid;
  const Budget budget(developed(setup, 0.004, 25), setup);
  double momentum = 0;
  for (int j = 0; j < g.ny; ++j) {
    const double flux_above = j + 1 < g.ny ? budget("uv", j + 1) : 0;
    EXPECT_NEAR(budget("force_convection", j), -(flux_above - budget("uv", j)) * g.inv_dy[j], 1e-12);
    momentum += (budget("force_excess", j) + budget("force_elastic", j)) * g.dy[j];
  }
  EXPECT_GT(std::abs(momentum), 1e-9) << "the layer holds fast to the upper wall";
}

}  // namespace
}  // namespace softwall::statistics
