#include "solver/output/regrid.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/wall_normal_grid.hpp"
#include "solver/output/agree.hpp"
#include "solver/output/checkpoint_reader.hpp"
#include "solver/output/initial_checkpoint.hpp"
#include "solver/time/initial.hpp"

namespace softwall::output {

namespace {

/// Where a field lives: offset from the low face in x and z as a fraction of a cell, faces or centers in y.
struct Location {
  double x = 0.5, z = 0.5;
  bool on_y_faces = false;
  bool zero_on_walls = true;
};

std::vector<double> centers(const std::vector<double>& faces) {
  std::vector<double> y;
  for (std::size_t j = 1; j < faces.size(); ++j) y.push_back((faces[j - 1] + faces[j]) / 2);
  return y;
}

/// Heights of a source field's rows; the walls join them as nodes of value zero where they are not rows
/// anyway.
std::vector<double> nodes_of(const Location& at, const std::vector<double>& faces) {
  if (at.on_y_faces) return faces;
  std::vector<double> nodes = centers(faces);
  if (at.zero_on_walls) {
    nodes.insert(nodes.begin(), faces.front());
    nodes.push_back(faces.back());
  }
  return nodes;
}

/// Heights of the target's rows. Velocity ends with the fluid; pressure goes on through the layer.
std::vector<double> rows_of(const Location& at, const grid::Grid& g) {
  std::vector<double> y;
  const int rows = at.zero_on_walls ? g.ny_fluid : g.ny;
  for (int j = 0; j < rows; ++j) y.push_back(at.on_y_faces ? g.y_face[j] : g.y_center[j]);
  return y;
}

double mean(const Weight& w, double low, double high) { return (1 - w.share) * low + w.share * high; }

/// Reads a field plane by plane, only planes asked for, and remembers the last two.
class Planes {
 public:
  Planes(const CheckpointFile& file, std::string field, const Location& at)
      : file_(file), field_(std::move(field)), extents_(file.extents(field_)) {
    padding_ = at.zero_on_walls && !at.on_y_faces ? 1 : 0;
  }
  [[nodiscard]] int nz() const { return extents_[0]; }
  [[nodiscard]] int nx() const { return extents_[2]; }

  /// Plane z = k as [nodes][nx].
  const std::vector<double>& operator[](int k) {
    for (const auto& plane : kept_) {
      if (plane.k == k) return plane.values;
    }
    Plane& oldest = kept_[next_];
    next_ = 1 - next_;
    oldest = {k, file_.columns(field_, {0, nx(), k, 1})};
    const std::vector<double> wall(static_cast<std::size_t>(padding_ * nx()), 0.0);
    oldest.values.insert(oldest.values.begin(), wall.begin(), wall.end());
    oldest.values.insert(oldest.values.end(), wall.begin(), wall.end());
    return oldest.values;
  }

 private:
  struct Plane {
    int k = -1;
    std::vector<double> values;
  };
  const CheckpointFile& file_;
  std::string field_;
  std::array<int, 3> extents_;
  int padding_ = 0;
  std::array<Plane, 2> kept_;
  std::size_t next_ = 0;
};

void interpolate(const CheckpointFile& file, const std::string& name, const Location& at, const grid::Grid& g,
                 grid::Field& target) {
  Planes planes(file, "fields/" + name, at);
  const auto in_x = periodic_weights(planes.nx(), g.nx_global, at.x);
  const auto in_z = periodic_weights(planes.nz(), g.nz_global, at.z);
  const auto in_y = height_weights(nodes_of(at, file.values("grid/y_face")), rows_of(at, g));
  const auto stride = static_cast<std::size_t>(planes.nx());
  const auto q = target.view();
  for (int k = 0; k < g.nz; ++k) {
    const Weight& wz = in_z[static_cast<std::size_t>(g.z_begin + k)];
    const double *low = planes[wz.low].data(), *high = planes[wz.high].data();
    for (std::size_t j = 0; j < in_y.size(); ++j) {
      const auto row = [&](int node, const Weight& wx) {
        const std::size_t first = static_cast<std::size_t>(node) * stride;
        const auto a = first + static_cast<std::size_t>(wx.low),
                   b = first + static_cast<std::size_t>(wx.high);
        return mean(wz, mean(wx, low[a], low[b]), mean(wx, high[a], high[b]));
      };
      for (int i = 0; i < g.nx; ++i) {
        const Weight& wx = in_x[static_cast<std::size_t>(g.x_begin + i)];
        q(i, static_cast<int>(j), k) = mean(in_y[j], row(in_y[j].low, wx), row(in_y[j].high, wx));
      }
    }
  }
}

void must_fit(const char* what, double in_file, double expected) {
  if (std::abs(in_file - expected) <= 1e-12 * std::abs(expected)) return;
  throw AgreedError(ExitCode::kBadCase, std::string("the precursor's ") + what + " is " +
                                            std::to_string(in_file) + ", this case needs " +
                                            std::to_string(expected));
}

/// Throws unless the file is such a checkpoint, and of the same box.
void check_precursor(const std::filesystem::path& path, const InitialSpec& initial, const grid::Grid& g) {
  const CheckpointHeader header = check_initial_checkpoint(path, initial);
  must_fit("length in x", header.length[0], g.length_x);
  must_fit("height", header.length[1], kFluidHeight);
  must_fit("length in z", header.length[2], g.length_z);
}

}  // namespace

std::vector<Weight> periodic_weights(int source, int target, double offset) {
  std::vector<Weight> weights;
  for (int i = 0; i < target; ++i) {
    const double position = (i + offset) * source / target - offset;
    const double low = std::floor(position);
    const auto wrapped = [=](double index) { return (static_cast<int>(index) + source) % source; };
    weights.push_back({wrapped(low), wrapped(low + 1), position - low});
  }
  return weights;
}

std::vector<Weight> height_weights(const std::vector<double>& nodes, const std::vector<double>& y) {
  std::vector<Weight> weights;
  const int last = static_cast<int>(nodes.size()) - 1;
  for (const double height : y) {
    const auto above = std::upper_bound(nodes.begin(), nodes.end(), height);
    const int low = static_cast<int>(above - nodes.begin()) - 1;
    if (low < 0 || low >= last) {
      const int end = low < 0 ? 0 : last;
      weights.push_back({end, end, 0});
      continue;
    }
    const double below = nodes[static_cast<std::size_t>(low)];
    weights.push_back({low, low + 1, (height - below) / (*above - below)});
  }
  return weights;
}

time::State start_from_precursor(const std::filesystem::path& checkpoint, const InitialSpec& initial,
                                 time::Setup& setup) {
  const auto& all = setup.decomposition.all();
  const auto& g = setup.grid;
  agree_on_root(all, ExitCode::kCheckpointRefused, [&] { check_precursor(checkpoint, initial, g); });
  time::State state = time::state_at_rest(setup);
  agree(all, ExitCode::kCheckpointRefused, [&] {
    const CheckpointFile file(checkpoint);
    interpolate(file, "u", {.x = 0.0}, g, state.velocity.x);
    interpolate(file, "v", {.on_y_faces = true}, g, state.velocity.y);
    interpolate(file, "w", {.z = 0.0}, g, state.velocity.z);
    interpolate(file, "p", {.zero_on_walls = false}, g, state.pressure);
  });
  time::make_solenoidal(state, setup);
  return state;
}

}  // namespace softwall::output
