#include "solver/solid/formulation.hpp"

#include "solver/solid/reference_map/reference_map.hpp"
#include "solver/solid/transported_b/transported_b.hpp"

namespace softwall::solid {

std::unique_ptr<Formulation> make_formulation(const SolidSpec& spec, const Grid& grid,
                                              const parallel::Decomposition& decomposition,
                                              grid::Halo& halo) {
  if (spec.formulation == SolidFormulation::kReferenceMap)
    return std::make_unique<reference_map::ReferenceMap>(spec, grid, decomposition, halo);
  return std::make_unique<TransportedB>(spec, grid, decomposition, halo);
}

}  // namespace softwall::solid
