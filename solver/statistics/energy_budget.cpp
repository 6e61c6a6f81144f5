#include "solver/statistics/energy_budget.hpp"

#include <span>
#include <stdexcept>
#include <utility>

#include "solver/case/elastic_law.hpp"
#include "solver/fluid/momentum.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/solid/cofactors.hpp"
#include "solver/solid/stress_work.hpp"

namespace softwall::statistics {

namespace {

using fluid::MomentumRow;
using grid::Grid;
using grid::Real;

/// In the order of kBudgetKinds.
enum BudgetIndex : std::size_t {
  kMeanU,
  kFluxUv,
  kKinetic,
  kElasticEnergy,
  kForces,  ///< of convection, viscosity, excess viscosity, elasticity, driving
  kPowers = kForces + 5,
  kPowerOfPressure = kPowers + 5,
  kWorkViscous,
  kWorkExcess,
  kWorkElastic,
  kRateU,
  kRateKinetic,
  kBudgetIndices
};
static_assert(kBudgetIndices == kBudgetKinds.size());
/// Of a force among the forces and among the powers.
constexpr std::size_t kConvection = 0, kViscosity = 1, kExcess = 2, kElasticity = 3, kDriving = 4;

/// Sums over this rank's columns, [kind][row].
class BudgetSums {
 public:
  explicit BudgetSums(const Grid& g)
      : grid_(g), values_(kBudgetKinds.size() * static_cast<std::size_t>(g.ny)) {}

  double& operator()(std::size_t kind, int j) {
    return values_[kind * static_cast<std::size_t>(grid_.ny) + static_cast<std::size_t>(j)];
  }
  /// Something that stands on the lower face of row j (not on a wall) and belongs to the rows on both sides.
  void add_on_face(std::size_t kind, int j, double value) {
    (*this)(kind, j) += value * grid_.dy_face[j] * grid_.inv_dy[j] / 2;
    (*this)(kind, j - 1) += value * grid_.dy_face[j] * grid_.inv_dy[j - 1] / 2;
  }
  void add_rows(std::size_t kind, std::span<const double> rows, double factor) {
    for (std::size_t j = 0; j < rows.size(); ++j) (*this)(kind, static_cast<int>(j)) += factor * rows[j];
  }
  std::vector<double>& values() { return values_; }

 private:
  const Grid& grid_;
  std::vector<double> values_;
};

/// Adds factor times the power of a force to `power`, and its x component to `force` unless that is no kind.
struct PowerOf {
  const grid::VectorField& velocity;
  const Grid& g;
  BudgetSums& sums;
  std::size_t force, power;
  double factor = 1;

  /// `f`: components in row (j, k); y is not read in row 0, whose y faces lie on the wall.
  void add(int j, int k, const MomentumRow& f) const {
    const auto u = velocity.x.view(), v = velocity.y.view(), w = velocity.z.view();
    const Real *const x = f.x, *const y = f.y, *const z = f.z;
    double along_x = 0, of_row = 0, on_face = 0;
#pragma omp simd reduction(+ : along_x, of_row)
    for (int i = 0; i < g.nx; ++i) {
      along_x += x[i];
      of_row += double(u(i, j, k)) * x[i] + double(w(i, j, k)) * z[i];
    }
    if (force < kBudgetIndices) sums(force, j) += factor * along_x;
    sums(power, j) += factor * of_row;
    if (j == 0) return;
#pragma omp simd reduction(+ : on_face)
    for (int i = 0; i < g.nx; ++i) on_face += double(v(i, j, k)) * y[i];
    sums.add_on_face(power, j, factor * on_face);
  }
};

void add_motion(const time::State& s, const fluid::MomentumInput& m, const Grid& g, BudgetSums& sums) {
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      double u1 = 0, squares = 0, v2 = 0, uv = 0;
#pragma omp simd reduction(+ : u1, squares, v2, uv)
      for (int i = 0; i < g.nx; ++i) {
        const double u = m.u(i, j, k), v = m.v(i, j, k), w = m.w(i, j, k);
        u1 += u;
        squares += u * u + w * w;
        v2 += v * v;
        uv += (u + m.u(i, j - 1, k)) / 2 * ((v + m.v(i - 1, j, k)) / 2);
      }
      sums(kMeanU, j) += u1;
      sums(kKinetic, j) += squares / 2;
      sums(kFluxUv, j) += uv;
      sums(kForces + kDriving, j) += s.driving_gradient * g.nx;
      sums(kPowers + kDriving, j) += s.driving_gradient * u1;
      if (j > 0) sums.add_on_face(kKinetic, j, v2 / 2);
    }
  }
}

/// The sum of all forces but the pressure gradient.
class AllForces {
 public:
  explicit AllForces(const Grid& g) : grid_(g), sum_(g, 1, grid::Memory::kByPlane) {}

  void add(int j, int k, const MomentumRow& f, Real factor = 1) {
    add_row(sum_.x, j, k, f.x, factor);
    if (j > 0) add_row(sum_.y, j, k, f.y, factor);
    add_row(sum_.z, j, k, f.z, factor);
  }
  grid::VectorField& sum() { return sum_; }

 private:
  void add_row(grid::Field& component, int j, int k, const Real* more, Real factor) {
    Real* const sum = &component(0, j, k);
#pragma omp simd
    for (int i = 0; i < grid_.nx; ++i) sum[i] += factor * more[i];
  }

  const Grid& grid_;
  grid::VectorField sum_;
};

/// The pressure that keeps the flow without divergence at this very moment. That of the state is the mean of
/// the last substep, dt / 6 earlier, which is too early where it goes with a wave.
void add_pressure(const time::State& s, AllForces& forces, time::Setup& setup, BudgetSums& sums) {
  const Grid& g = setup.grid;
  setup.projection->find_psi(forces.sum(), 1);
  const auto p = setup.projection->psi().view();
  const auto length = static_cast<std::size_t>(g.nx);
  std::vector<Real> x(length), y(length), z(length);
  const PowerOf power{s.velocity, g, sums, kBudgetIndices, kPowerOfPressure};
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      for (std::size_t n = 0; n < length; ++n) {
        const int i = static_cast<int>(n);
        x[n] = -(p(i, j, k) - p(i - 1, j, k)) / Real(g.dx);
        y[n] = j > 0 ? -(p(i, j, k) - p(i, j - 1, k)) * Real(g.inv_dy_face[j]) : 0;
        z[n] = -(p(i, j, k) - p(i, j, k - 1)) / Real(g.dz);
      }
      power.add(j, k, {x.data(), y.data(), z.data()});
    }
  }
}

/// The stress that mu_f has everywhere.
struct FluidStress {
  static constexpr bool kAcrossRowsOnly = false;
  fluid::MomentumInput m;
  Real xx(int i, int j, int k) const { return 2 * m.nu * (m.u(i + 1, j, k) - m.u(i, j, k)) * m.inv_dx; }
  Real yy(int i, int j, int k) const { return 2 * m.nu * (m.v(i, j + 1, k) - m.v(i, j, k)) * m.inv_dy[j]; }
  Real zz(int i, int j, int k) const { return 2 * m.nu * (m.w(i, j, k + 1) - m.w(i, j, k)) * m.inv_dz; }
  Real xy(int i, int j, int k) const { return fluid::stress_xy(m, i, j, k); }
  Real yz(int i, int j, int k) const { return fluid::stress_yz(m, i, j, k); }
  Real xz(int i, int j, int k) const { return fluid::stress_xz(m, i, j, k); }
};

void add_elastic_energy(const time::State& s, const time::Setup& setup, BudgetSums& sums) {
  const Grid& g = setup.grid;
  const auto phi = s.material.phi.view();
  const solid::Cofactors C = solid::cofactors_of(s.material, g);
  const auto law = law_of<double>(*setup.physics.solid);
  for (int k = 0; k < g.nz; ++k) {
    for (int j = setup.solid->first_row(); j < g.ny; ++j) {
      double energy = 0;
      for (int i = 0; i < g.nx; ++i) {
        const double of_B = double(C.Bxx(i, j, k)) + C.Byy(i, j, k) + C.Bzz(i, j, k);
        const double of_C =
            law.is_neo_hookean() ? of_B : double(C.xx(i, j, k)) + C.yy(i, j, k) + C.zz(i, j, k);
        energy += phi(i, j, k) * law.energy(of_B, of_C);
      }
      sums(kElasticEnergy, j) += energy;
    }
  }
}

void add_solid(const time::State& s, time::Setup& setup, AllForces& forces, BudgetSums& sums) {
  const Grid& g = setup.grid;
  const int first = setup.solid->first_row();
  const auto action = setup.solid->action(s.material, s.velocity);
  const auto add = [&](const grid::VectorField* force, std::size_t term, int end_row, double factor) {
    if (!force) return;
    const PowerOf power{s.velocity, g, sums, kForces + term, kPowers + term, factor};
    const auto x = force->x.view(), y = force->y.view(), z = force->z.view();
    for (int k = 0; k < g.nz; ++k) {
      for (int j = first; j < end_row; ++j) {
        const MomentumRow row{&x(0, j, k), &y(0, j, k), &z(0, j, k)};
        power.add(j, k, row);
        forces.add(j, k, row, Real(factor));
      }
    }
  };
  add(action.elastic, kElasticity, g.ny, 1);
  add(action.excess, kExcess, action.excess_end_row, setup.viscosity);
  add(action.across, kExcess, g.ny, setup.viscosity);
  sums.add_rows(kWorkElastic, action.elastic_work, 1);
  sums.add_rows(kWorkExcess, action.excess_work, setup.viscosity);
  add_elastic_energy(s, setup, sums);
}

/// u, then kinetic, by row: what kRateU and kRateKinetic are the rates of.
std::vector<double> motion_of(const std::vector<double>& sample, std::size_t rows) {
  static_assert(kRateKinetic == kRateU + 1);
  std::vector<double> motion;
  for (const std::size_t kind : {kMeanU, kKinetic}) {
    const auto first = sample.begin() + static_cast<std::ptrdiff_t>(kind * rows);
    motion.insert(motion.end(), first, first + static_cast<std::ptrdiff_t>(rows));
  }
  return motion;
}

}  // namespace

std::optional<std::vector<double>> EnergyBudget::sample(const time::State& s, time::Setup& setup,
                                                        double elapsed) {
  const Grid& g = setup.grid;
  BudgetSums sums(g);
  const auto with_viscosity = fluid::momentum_input(s.velocity, g, setup.viscosity),
             without = fluid::momentum_input(s.velocity, g, 0);
  add_motion(s, without, g, sums);
  const auto power_of = [&](std::size_t term, double factor) {
    return PowerOf{s.velocity, g, sums, kForces + term, kPowers + term, factor};
  };
  const PowerOf convection = power_of(kConvection, 1), both = power_of(kViscosity, 1),
                taken_away = power_of(kViscosity, -1);  // convection, from what viscosity has with it
  AllForces forces(g);
  sweep_.for_each_row(with_viscosity, 0, g.ny, [&](int j, int k, const MomentumRow& row) {
    both.add(j, k, row);
    forces.add(j, k, row);
  });
  sweep_.for_each_row(without, 0, g.ny, [&](int j, int k, const MomentumRow& row) {
    convection.add(j, k, row);
    taken_away.add(j, k, row);
  });
  std::vector<double> work(static_cast<std::size_t>(g.ny));
  solid::add_stress_work(FluidStress{with_viscosity}, s.velocity, g, 0, g.ny, work);
  sums.add_rows(kWorkViscous, work, 1);
  if (setup.solid) add_solid(s, setup, forces, sums);
  add_pressure(s, forces, setup, sums);
  parallel::sum(setup.decomposition.all(), sums.values());
  for (double& value : sums.values()) value /= double(g.nx_global) * g.nz_global;
  const std::vector<double> before = std::exchange(before_, motion_of(sums.values(), rows_));
  if (before.empty()) return std::nullopt;
  for (std::size_t n = 0; n < before.size(); ++n)
    sums.values()[kRateU * rows_ + n] = (before_[n] - before[n]) / elapsed;
  return std::move(sums.values());
}

void EnergyBudget::continue_from(std::span<const double> before) {
  if (before.size() != 2 * rows_)
    throw std::runtime_error("statistics of a checkpoint belong to another grid");
  before_.assign(before.begin(), before.end());
}

}  // namespace softwall::statistics
