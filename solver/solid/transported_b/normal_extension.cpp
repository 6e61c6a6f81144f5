#include "solver/solid/transported_b/normal_extension.hpp"

#include <algorithm>
#include <utility>

#include "solver/parallel/reduce.hpp"
#include "solver/solid/fraction.hpp"

namespace softwall::solid {

namespace {

/// Layers that can be filled between two exchanges: marks are known two cells beyond the rank's own.
constexpr int kMargin = 2;

/// Weight of a neighbour that is no more solid, in units of phi: decides only where no neighbour is.
constexpr Real kEqual = 1e-6;

}  // namespace

NormalExtension::NormalExtension(const Grid& grid, const parallel::Decomposition& decomposition,
                                 grid::Halo& halo)
    : grid_(grid),
      decomposition_(decomposition),
      halo_(halo),
      at_center_(grid, Material::kGhost),
      at_xy_(grid, Material::kGhost),
      at_xz_(grid, Material::kGhost),
      at_yz_(grid, Material::kGhost) {}

grid::Box NormalExtension::solid_box(const grid::Field& phi, double threshold) const {
  const auto& g = grid_;
  std::array<int, 6> least{g.nx_global, g.ny, g.nz_global, 1, 1, 1};  // lowest cell; minus the end
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        if (phi(i, j, k) < threshold) continue;
        const std::array<int, 3> at{g.x_begin + i, j, g.z_begin + k};
        for (std::size_t d = 0; d < 3; ++d) {
          least[d] = std::min(least[d], at[d]);
          least[d + 3] = std::min(least[d + 3], -at[d] - 1);
        }
      }
    }
  }
  std::array<int, 6> all{};
  parallel::check(MPI_Allreduce(least.data(), all.data(), 6, MPI_INT, MPI_MIN, decomposition_.all().get()),
                  "MPI_Allreduce");
  return {all[0], -all[3], all[1], -all[4], all[2], -all[5]};
}

grid::Box NormalExtension::near_solid(const grid::Box& solid, int cells, int rows) const {
  const auto& g = grid_;
  // Between exchanges a layer is wanted in the ghost cells too, in one column less each time.
  const int beyond = kMargin - 1 - (cells - 1) % kMargin, beyond_z = g.nz_global == 1 ? 0 : beyond;
  grid::Box box{-beyond, g.nx + beyond, 0, rows, -beyond_z, g.nz + beyond_z};
  if (g.walls_in_x) {
    box.i0 = std::max(box.i0, solid.i0 - cells - g.x_begin);
    box.i1 = std::min(box.i1, solid.i1 + cells + 1 - g.x_begin);
  }
  box.j0 = std::max(box.j0, solid.j0 - cells);
  box.j1 = std::min(box.j1, solid.j1 + cells + 1);
  return box;
}

template <class FractionAt>
void NormalExtension::mark(const FractionAt& fraction, double threshold, int rows, grid::Field& known) const {
  const auto& g = grid_;
  const auto mark = known.view();
  const grid::Box box{-kMargin, g.nx + kMargin, 0, rows, -kMargin, g.nz + kMargin};
  grid::for_each_cell(
      box, [=](int i, int j, int k) { mark(i, j, k) = fraction(i, j, k) < threshold ? Real(0) : Real(1); });
}

template <class FractionAt, std::size_t kCount>
void NormalExtension::grow(const FractionAt& fraction, const std::array<grid::Field*, kCount>& components,
                           const grid::Box& box, int rows, grid::Field& known) {
  const auto& g = grid_;
  const auto mark = known.view();
  const Real in_x = 1 / (g.dx * g.dx), in_z = g.nz_global == 1 ? 0 : 1 / (g.dz * g.dz);
  updates_.clear();
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
      const Real in_y = g.inv_dy[j] * g.inv_dy[j];
      for (int i = box.i0; i < box.i1; ++i) {
        if (mark(i, j, k) != 0) continue;
        Update update{i, j, k, {}};
        Real weights = 0;
        const Real here = fraction(i, j, k);
        const auto take = [&](int a, int b, int c, Real scale) {
          if (mark(a, b, c) == 0 || scale == 0) return;
          const Real weight = scale * (std::max(fraction(a, b, c) - here, Real(0)) + kEqual);
          weights += weight;
          for (std::size_t n = 0; n < kCount; ++n) update.value[n] += weight * (*components[n])(a, b, c);
        };
        take(i - 1, j, k, in_x);
        take(i + 1, j, k, in_x);
        if (j > 0) take(i, j - 1, k, in_y);
        if (j + 1 < rows) take(i, j + 1, k, in_y);
        take(i, j, k - 1, in_z);
        take(i, j, k + 1, in_z);
        if (weights == 0) continue;
        for (Real& value : update.value) value /= weights;
        updates_.push_back(update);
      }
    }
  }
  for (const Update& update : updates_) {
    mark(update.i, update.j, update.k) = 1;
    for (std::size_t n = 0; n < kCount; ++n) {
      (*components[n])(update.i, update.j, update.k) = update.value[n];
    }
  }
}

template <std::size_t kCount>
void NormalExtension::clear(const std::array<grid::Field*, kCount>& components, const grid::Field& known,
                            int rows, Real value) const {
  const auto mark = known.view();
  for (grid::Field* component : components) {
    const auto b = component->view();
    grid::for_each_cell(grid::rows(grid_, 0, rows), [=](int i, int j, int k) {
      const Real own = b(i, j, k);
      b(i, j, k) = mark(i, j, k) != 0 ? own : value;
    });
  }
}

/// Exchanges ghost cells in the rows reached so far. A flat closed box that is whole on one rank has nobody
/// to exchange with.
void NormalExtension::exchange(std::initializer_list<grid::Field*> fields, const grid::Box& solid,
                               int cells) {
  const bool alone = decomposition_.all().size() == 1 && grid_.walls_in_x && grid_.nz_global == 1;
  if (alone || solid.j0 >= solid.j1) return;
  halo_.fill(fields, {std::max(0, solid.j0 - cells), std::min(grid_.ny, solid.j1 + cells) + 1});
}

void NormalExtension::extend_shear(Material& material, double threshold) {
  const Fraction phi{std::as_const(material.phi).view(), grid_.upper_share.data()};
  const auto on_xy = [=](int i, int j, int k) { return phi.edge_xy(i, j, k); };
  const auto on_xz = [=](int i, int j, int k) { return phi.edge_xz(i, j, k); };
  const auto on_yz = [=](int i, int j, int k) { return phi.edge_yz(i, j, k); };
  auto& B = material.B;
  const int ny = grid_.ny;
  mark(on_xy, threshold, ny + 1, at_xy_);
  mark(on_xz, threshold, ny, at_xz_);
  mark(on_yz, threshold, ny + 1, at_yz_);
  const grid::Box solid = solid_box(material.phi, threshold);
  for (int layer = 1; layer <= kLayers; ++layer) {
    grow(on_xy, std::array{&B.xy}, near_solid(solid, layer, ny + 1), ny + 1, at_xy_);
    grow(on_xz, std::array{&B.xz}, near_solid(solid, layer, ny), ny, at_xz_);
    grow(on_yz, std::array{&B.yz}, near_solid(solid, layer, ny + 1), ny + 1, at_yz_);
    if (layer % kMargin == 0 && layer < kLayers)
      exchange({&B.xy, &B.xz, &B.yz, &at_xy_, &at_xz_, &at_yz_}, solid, layer);
  }
  clear(std::array{&B.xy}, at_xy_, ny + 1, 0);
  clear(std::array{&B.xz}, at_xz_, ny, 0);
  clear(std::array{&B.yz}, at_yz_, ny + 1, 0);
}

void NormalExtension::extend_normal(Material& material, double threshold) {
  const Fraction phi{std::as_const(material.phi).view(), grid_.upper_share.data()};
  const auto center = [=](int i, int j, int k) { return phi.center(i, j, k); };
  auto& B = material.B;
  const int ny = grid_.ny;
  const std::array normal{&B.xx, &B.yy, &B.zz};
  mark(center, threshold, ny, at_center_);
  const grid::Box solid = solid_box(material.phi, threshold);
  for (int layer = 1; layer <= kLayers; ++layer) {
    grow(center, normal, near_solid(solid, layer, ny), ny, at_center_);
    if (layer % kMargin == 0 && layer < kLayers) exchange({&B.xx, &B.yy, &B.zz, &at_center_}, solid, layer);
  }
  clear(normal, at_center_, ny, 1);
}

}  // namespace softwall::solid
