#pragma once

#include <optional>

#include "solver/case/case.hpp"
#include "solver/fluid/predictor.hpp"
#include "solver/fluid/walls.hpp"
#include "solver/grid/halo.hpp"
#include "solver/parallel/profile.hpp"
#include "solver/pressure/closed_box/box_projection.hpp"
#include "solver/pressure/projection.hpp"
#include "solver/solid/solid.hpp"
#include "solver/time/closed_box/implicit_viscosity.hpp"
#include "solver/time/state.hpp"

namespace softwall::time {

/// What a case and a number of ranks determine: grid, plans, work arrays. Holds nothing that a restart would
/// miss. Members refer to each other, so it neither moves nor copies.
class Setup {
 public:
  /// `layout`: how the columns are shared; the first possible one unless given.
  Setup(const Physics& physics, MPI_Comm comm, std::optional<parallel::Layout> layout = std::nullopt);
  Setup(const Setup&) = delete;
  Setup& operator=(const Setup&) = delete;

  const Physics physics;
  const parallel::Decomposition decomposition;
  mutable parallel::Profile profile;  ///< of no effect on any result
  const grid::Grid grid;
  const double viscosity;  ///< 1 / Re
  fluid::Walls walls;
  std::optional<double> bulk_velocity;  ///< held by the driving gradient; empty: no driving
  const bool velocity_prescribed;       ///< the velocity stays as it is and carries the solid
  grid::Halo halo;
  fluid::Predictor predictor;
  std::optional<pressure::Projection> projection;         ///< of a channel
  std::optional<pressure::BoxProjection> box_projection;  ///< of a closed box
  std::optional<ImplicitViscosity> implicit_viscosity;
  std::optional<solid::Solid> solid;
};

}  // namespace softwall::time
