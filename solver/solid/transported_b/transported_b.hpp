#pragma once

#include <optional>

#include "solver/case/case.hpp"
#include "solver/grid/halo.hpp"
#include "solver/solid/formulation.hpp"
#include "solver/solid/transported_b/advection.hpp"
#include "solver/solid/transported_b/fraction_transport.hpp"
#include "solver/solid/transported_b/height_transport.hpp"
#include "solver/solid/transported_b/normal_extension.hpp"
#include "solver/solid/transported_b/solid_edges.hpp"

/// The paper's formulation: phi and B are carried by the flow, equations (6)-(7), phi as the case asks for:
///   phi^k = phi^{k-1} - dt [ beta div(u phi)^{k-1} + gamma div(u phi)^{k-2} ]
///   B^k   = B^{k-1} + dt [ beta (S - div(u B))^{k-1} + gamma (S - div(u B))^{k-2} ]
namespace softwall::solid {

class TransportedB : public Formulation {
 public:
  /// WENO reads three rows below the lowest of phi, which rises and falls by one in a step.
  static constexpr int kMargin = 4;

  TransportedB(const SolidSpec& spec, const Grid& grid, const parallel::Decomposition& decomposition,
               grid::Halo& halo);

  [[nodiscard]] int lowest_row(const Material& material) override;
  [[nodiscard]] int margin() const override { return kMargin; }
  void make_consistent(Material& material, int first_row, PlaneFollower& follower) override;
  void transport(Material& material, const grid::VectorField& velocity, const Stage& stage, double dt,
                 int first_row, PlaneFollower* follower) override;
  /// The phi from which on B of an edge is the solid's own. Around a body of any shape every edge counts as
  /// one, and the local shear stands in for the solid's.
  [[nodiscard]] Real solid_from() const override { return normal_ ? Real(0) : threshold_; }
  /// Where the interface is a height, stress is shared as with a reference map. Where phi is smeared, the
  /// mean by volume is taken: with the fluid's stress alone a layer of 32 x 32 + 8 x 32 cells fluttered there
  /// (MTHINC, G = 1: v' 0.19 at the interface).
  [[nodiscard]] const InterfaceShare& interface_share() const override { return share_; }
  /// Counts the cells that the limiter (limiter.hpp) has changed since the program started.
  [[nodiscard]] std::int64_t limited_cells() const override { return limited_cells_; }

 private:
  struct Rates {
    grid::Field phi;
    grid::TensorField B;
  };
  void find_rates(const Material& material, const grid::VectorField& velocity, int first_row);
  void update(Material& material, const Stage& stage, double dt, int first_row);
  void make_consistent(Material& material, int first_row);
  void show_planes(PlaneFollower& follower) const;
  void extend_layer(Material& material, int first_row);
  void extend_body(Material& material);
  void follow_surface(Material& material, int first_row);
  void fill_beyond_walls(Material& material, int first_row) const;

  SolidSpec spec_;
  Real threshold_;  ///< of spec_, as far as the interface allows
  const Grid& grid_;
  grid::Halo& halo_;
  Advection advection_;
  // At most one of these exists and moves phi, as the case asks; without either, advection_ moves it.
  std::optional<FractionTransport> fraction_;
  std::optional<HeightTransport> height_;
  Rates now_, before_;
  InterfaceShare share_;
  SolidEdges edges_;
  std::optional<NormalExtension> normal_;  ///< present when the case asks for it
  std::int64_t limited_cells_ = 0;
};

}  // namespace softwall::solid
