#include "solver/solid/transported_b/skin.hpp"

#include <array>
#include <utility>

#include "solver/solid/column_extension.hpp"
#include "solver/solid/fraction.hpp"
#include "solver/solid/transported_b/limiter.hpp"

namespace softwall::solid {

void extend_shear(Material& material, Real threshold, const Grid& g, const grid::Box& box) {
  const Fraction phi{std::as_const(material.phi).view(), g.upper_share.data()};
  auto& B = material.B;
  const auto on_xy = [=](int i, int j, int k) { return phi.edge_xy(i, j, k); };
  const auto on_xz = [=](int i, int j, int k) { return phi.edge_xz(i, j, k); };
  const auto on_yz = [=](int i, int j, int k) { return phi.edge_yz(i, j, k); };
  extend_down(std::array{&B.xy}, on_xy, threshold, g.ny - 1, box);
  extend_down(std::array{&B.xz}, on_xz, threshold, g.ny - 2, box);
  extend_down(std::array{&B.yz}, on_yz, threshold, g.ny - 1, box);
}

std::int64_t extend_normal(Material& material, Real threshold, double floor, const Grid& g,
                           const grid::Box& box) {
  const Fraction phi{std::as_const(material.phi).view(), g.upper_share.data()};
  auto& B = material.B;
  const auto center = [=](int i, int j, int k) { return phi.center(i, j, k); };
  grid::Box top = box;  // the row at the wall has nothing above it
  top.j0 = g.ny - 1;
  std::int64_t limited = keep_positive_definite(B, floor, top);
  extend_down(std::array{&B.xx, &B.yy, &B.zz}, center, threshold, g.ny - 2, box,
              [&](const grid::Box& row) { limited += keep_positive_definite(B, floor, row); });
  return limited;
}

}  // namespace softwall::solid
