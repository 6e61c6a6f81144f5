#include "solver/statistics/flow_spectra.hpp"

#include <algorithm>
#include <complex>

namespace softwall::statistics {

namespace {

using grid::Real;
using parallel::Range;

/// How many Fourier coefficients of a real row of n numbers have the power that mode m has.
double multiplicity(int m, int n) { return m == 0 || 2 * m == n ? 1 : 2; }

/// Gives the rows of one field and collects the power of its modes.
class PowerOfField final : public pressure::FieldRows {
 public:
  /// `lowest`: what stands for row 0, of all columns of this rank, if not empty.
  PowerOfField(const grid::Field& field, std::span<const Real> lowest, const grid::Grid& g, Range modes,
               Range rows)
      : field_(field),
        lowest_(lowest),
        grid_(g),
        first_mode_(modes.begin),
        rows_(rows.size()),
        along_x_(static_cast<std::size_t>(modes.size() * rows.size())),
        along_z_(static_cast<std::size_t>((g.nz_global / 2 + 1) * rows.size())) {}

  void give(int j, int k, Real* row) override {
    const Real* const from = j == 0 && !lowest_.empty() ? &lowest_[static_cast<std::size_t>(k * grid_.nx)]
                                                        : &field_.view()(0, j, k);
    std::copy_n(from, grid_.nx, row);
  }

  void take(int mode, Range rows, const pressure::Complex* plane, std::ptrdiff_t stride) override {
    for (int j = 0; j < rows.size(); ++j)
      along_x_[static_cast<std::size_t>((mode - first_mode_) * rows_ + j)] =
          power_of(plane + j * stride, mode, j);
  }

  /// [mode][row] of this rank's modes in x and rows.
  [[nodiscard]] const std::vector<double>& along_x() const { return along_x_; }
  /// [mode][row] of all modes in z: what this rank's modes in x contribute.
  [[nodiscard]] const std::vector<double>& along_z() const { return along_z_; }

 private:
  /// Of a row in one mode in x; adds that of each mode in z to what there is of it.
  double power_of(const pressure::Complex* row, int mode, int j) {
    const int nx = grid_.nx_global, nz = grid_.nz_global;
    const double scale = multiplicity(mode, nx) / (double(nx) * nx * nz * nz);
    double total = 0;
    for (int n = mode == 0 ? 1 : 0; n < nz; ++n) {
      const double power = scale * std::norm(std::complex<double>(row[n]));
      along_z_[static_cast<std::size_t>(std::min(n, nz - n) * rows_ + j)] += power;
      total += power;
    }
    return total;
  }

  const grid::Field& field_;
  std::span<const Real> lowest_;
  const grid::Grid& grid_;
  int first_mode_, rows_;
  std::vector<double> along_x_, along_z_;
};

}  // namespace

std::size_t FlowSpectra::Share::size() const {
  const int modes_of_both = modes(0).size() + modes(1).size();
  return kFields.size() * static_cast<std::size_t>(modes_of_both * rows().size());
}

FlowSpectra::FlowSpectra(const grid::Grid& grid, const parallel::Decomposition& decomposition)
    : grid_(grid),
      decomposition_(decomposition),
      own_(share_of(decomposition)),
      shares_(static_cast<std::size_t>(decomposition.all().size())) {
  constexpr int kBounds = static_cast<int>(sizeof(Share) / sizeof(int));
  parallel::check(MPI_Allgather(own_.bounds.data(), kBounds, MPI_INT, shares_.data(), kBounds, MPI_INT,
                                decomposition.all().get()),
                  "MPI_Allgather");
}

FlowSpectra::Share FlowSpectra::share_of(const parallel::Decomposition& d) const {
  const auto [modes_x, modes_z] = modes();
  const Range x = parallel::share(modes_x, d.pz(), d.z_line().rank()),
              z = parallel::share(modes_z, d.pz(), d.z_line().rank()),
              rows = parallel::share(grid_.ny, d.px(), d.x_line().rank());
  return {{x.begin, x.end, z.begin, z.end, rows.begin, rows.end}};
}

std::array<int, 2> FlowSpectra::modes() const { return {grid_.nx_global / 2 + 1, grid_.nz_global / 2 + 1}; }

std::size_t FlowSpectra::whole_size() const {
  return kFields.size() * static_cast<std::size_t>((modes()[0] + modes()[1]) * grid_.ny);
}

std::vector<double> FlowSpectra::part_of(const time::State& s, std::span<const double> heights,
                                         pressure::Poisson& transforms) const {
  const std::array<const grid::Field*, kFields.size()> fields{&s.velocity.x, &s.velocity.y, &s.velocity.z,
                                                              &s.pressure};
  std::vector<Real> rise;  // less the height at rest: in single precision the digits that matter
  for (const double height : heights) rise.push_back(Real(height - grid_.y_face[grid_.ny_fluid]));
  std::vector<double> part, along_z;
  for (const grid::Field* field : fields) {
    const bool is_v = field == &s.velocity.y;
    PowerOfField power(*field, is_v ? std::span<const Real>(rise) : std::span<const Real>(), grid_,
                       own_.modes(0), own_.rows());
    transforms.transform(power);
    part.insert(part.end(), power.along_x().begin(), power.along_x().end());
    const auto summed = summed_over_x(power.along_z());
    along_z.insert(along_z.end(), summed.begin(), summed.end());
  }
  part.insert(part.end(), along_z.begin(), along_z.end());
  return part;
}

/// The modes in x are shared among the ranks of a line in z: adds what each has of a spectrum along z, in the
/// order of the ranks. Returns this rank's share of the modes.
std::vector<double> FlowSpectra::summed_over_x(const std::vector<double>& spectrum) const {
  const auto& line = decomposition_.z_line();
  const int rows = own_.rows().size(), mine = own_.modes(1).size() * rows;
  std::vector<int> sent, from, got, to;
  for (const Range& modes : parallel::shares(modes()[1], line.size())) {
    sent.push_back(modes.size() * rows);
    from.push_back(modes.begin * rows);
    to.push_back(static_cast<int>(got.size()) * mine);
    got.push_back(mine);
  }
  std::vector<double> parts(static_cast<std::size_t>(mine) * got.size()), sum(static_cast<std::size_t>(mine));
  parallel::check(MPI_Alltoallv(spectrum.data(), sent.data(), from.data(), MPI_DOUBLE, parts.data(),
                                got.data(), to.data(), MPI_DOUBLE, line.get()),
                  "MPI_Alltoallv");
  for (std::size_t n = 0; n < parts.size(); ++n) sum[n % sum.size()] += parts[n];
  return sum;
}

/// Calls visit(place in the part, place in the whole, numbers) for every contiguous run of numbers.
template <class Visit>
void FlowSpectra::for_each_row(const Share& share, const Visit& visit) const {
  const auto rows = static_cast<std::size_t>(share.rows().size()), ny = static_cast<std::size_t>(grid_.ny);
  std::size_t in_part = 0, first_mode = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Range own = share.modes(axis);
    for (std::size_t field = 0; field < kFields.size(); ++field) {
      for (int m = own.begin; m < own.end; ++m, in_part += rows) {
        const std::size_t row = (first_mode + static_cast<std::size_t>(m)) * ny;
        visit(in_part, row + static_cast<std::size_t>(share.rows().begin), rows);
      }
      first_mode += static_cast<std::size_t>(modes()[axis]);
    }
  }
}

std::vector<double> FlowSpectra::whole(std::span<const double> part) const {
  const auto& all = decomposition_.all();
  std::vector<int> counts, starts;
  int total = 0;
  for (const Share& share : shares_) {
    starts.push_back(total);
    counts.push_back(static_cast<int>(share.size()));
    total += counts.back();
  }
  const bool root = all.rank() == 0;
  std::vector<double> parts(root ? static_cast<std::size_t>(total) : 0), whole(root ? whole_size() : 0);
  parallel::check(MPI_Gatherv(part.data(), static_cast<int>(part.size()), MPI_DOUBLE, parts.data(),
                              counts.data(), starts.data(), MPI_DOUBLE, 0, all.get()),
                  "MPI_Gatherv");
  for (std::size_t rank = 0; root && rank < shares_.size(); ++rank) {
    const double* const from = parts.data() + starts[rank];
    for_each_row(shares_[rank], [&](std::size_t in_part, std::size_t in_whole, std::size_t n) {
      std::copy_n(from + in_part, n, &whole[in_whole]);
    });
  }
  return whole;
}

std::vector<double> FlowSpectra::part(std::span<const double> whole) const {
  std::vector<double> part(part_size());
  for_each_row(own_, [&](std::size_t in_part, std::size_t in_whole, std::size_t n) {
    std::copy_n(&whole[in_whole], n, &part[in_part]);
  });
  return part;
}

}  // namespace softwall::statistics
