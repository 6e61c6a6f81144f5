#pragma once

#include "solver/solid/formulation.hpp"

namespace softwall::support {

/// Asks a formulation for B without doing anything with it.
class NoFollower final : public solid::PlaneFollower {
  void plane_is_ready(int /*k*/) override {}
};

}  // namespace softwall::support
