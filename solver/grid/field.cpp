#include "solver/grid/field.hpp"

#include <cstdlib>
#include <new>

namespace softwall::grid {

void Field::Free::operator()(Real* p) const { std::free(p); }

Field::Field(const Grid& g, int ghost) : nx_(g.nx), ny_(g.ny), nz_(g.nz), ghost_(ghost) {
  stride_y_ = nx_ + 2 * ghost_;
  stride_z_ = stride_y_ * (ny_ + 2 * ghost_);
  const auto count = static_cast<std::size_t>(stride_z_) * static_cast<std::size_t>(nz_ + 2 * ghost_);
  memory_.reset(static_cast<Real*>(std::calloc(count, sizeof(Real))));
  if (!memory_) throw std::bad_alloc();
}

}  // namespace softwall::grid
