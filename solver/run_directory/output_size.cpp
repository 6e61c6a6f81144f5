#include "solver/run_directory/output_size.hpp"

#include <cstddef>

namespace softwall {
namespace {

/// Fields with values at the ny cell centers of a column, and on its ny + 1 faces.
struct StoredFields {
  int centers = 0, faces = 0;
};

/// What a checkpoint stores (time::fields_of names the fields; a test compares): velocity and pressure; for a
/// solid the displacement of the reference map, or the solid fraction and the tensor B.
StoredFields stored_fields(const Physics& physics) {
  if (!physics.solid) return {3, 1};
  return physics.solid->formulation == SolidFormulation::kReferenceMap ? StoredFields{5, 2}
                                                                       : StoredFields{8, 3};
}

/// Velocity and pressure; for a solid its fraction, and its displacement or B.
int snapshot_fields(const Physics& physics) {
  if (!physics.solid) return 4;
  return physics.solid->formulation == SolidFormulation::kReferenceMap ? 8 : 11;
}

std::int64_t bytes_of_rows(std::int64_t rows, const Physics& physics) {
  const std::size_t bytes = physics.precision == Precision::kSingle ? sizeof(float) : sizeof(double);
  return rows * physics.grid.nx * physics.grid.nz * static_cast<std::int64_t>(bytes);
}

}  // namespace

std::int64_t checkpoint_field_bytes(const Physics& physics) {
  const StoredFields stored = stored_fields(physics);
  const std::int64_t ny = physics.grid.ny();
  return bytes_of_rows(stored.centers * ny + stored.faces * (ny + 1), physics);
}

std::int64_t snapshot_field_bytes(const Physics& physics) {
  return bytes_of_rows(std::int64_t{snapshot_fields(physics)} * physics.grid.ny(), physics);
}

std::int64_t film_moment_bytes(const Physics& physics, const PlaneSpec& planes) {
  const std::int64_t nx = physics.grid.nx, ny = physics.grid.ny(), nz = physics.grid.nz;
  const auto across = [](const std::vector<double>& positions) { return std::ssize(positions); };
  const std::int64_t points =
      across(planes.x) * ny * nz + across(planes.y) * nx * nz + across(planes.z) * nx * ny;
  const std::int64_t fields = physics.solid ? 5 : 4;  // velocity and pressure; the solid fraction
  const bool has_interface = physics.solid && !is_closed_box(physics.flow);
  return (fields * points + (has_interface ? nx * nz : 0)) * static_cast<std::int64_t>(sizeof(float));
}

}  // namespace softwall
