#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/grid/field.hpp"
#include "solver/solid/material.hpp"

/// All that a checkpoint stores of the flow. Everything else can be recomputed from the case and this, so a
/// restarted run repeats an uninterrupted one bit for bit.
namespace softwall::time {

struct State {
  grid::VectorField velocity;  ///< U_b, on faces
  grid::Field pressure;        ///< rho U_b^2, at centers, without the mean driving gradient
  solid::Material material;    ///< empty fields in a rigid channel; its formulation says which are the state
  bool elastic = false;
  double time = 0;  ///< h / U_b
  std::int64_t step = 0;
  double driving_gradient = 0;  ///< P averaged over the last step, rho U_b^2 / h
};

/// A field of the state with its name and the number of rows that carry information
/// (ny, or ny + 1 for what lives on y faces and has a value on the upper wall).
struct NamedField {
  std::string name;
  std::string description;
  grid::Field* field;
  int rows;
};

/// Every field of the state, always in the same order: the contents of a checkpoint.
[[nodiscard]] std::vector<NamedField> fields_of(State& state);

/// A fluid at rest and, in an elastic case, a flat layer at rest in the given formulation.
[[nodiscard]] State state_at_rest(const grid::Grid& grid, std::optional<SolidFormulation> formulation);

/// True when every number of the state is finite, on all ranks.
[[nodiscard]] bool is_finite(const State& state, const parallel::Decomposition& decomposition);

}  // namespace softwall::time
