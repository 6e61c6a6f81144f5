#include "solver/output/checkpoint_writer.hpp"

#include <array>

#include "solver/case/atomic_file.hpp"
#include "solver/output/agree.hpp"
#include "solver/output/parallel_file.hpp"
#include "solver/output/watchdog.hpp"
#include "solver/run_directory/build_info.hpp"

// Contents of the file: /time, /step, /driving_gradient; /grid/y_face; /fields/<name>, one [nz][rows][nx]
// array for each of fields_of(); /statistics/accumulators and sums of Spectra; /diagnostics/*. No filters, no
// time stamps: the same state gives the same bytes behind the header. The digest of the whole file takes the
// place of checksums by dataset.
namespace softwall::output {

namespace {

void write_contents(const std::filesystem::path& file, time::State& state, const CheckpointContents& record,
                    const time::Setup& setup) {
  ParallelFile out(file, setup.decomposition.all(), kCheckpointHeaderBytes);
  out.write_number({"time", "simulated time, h / U_b"}, state.time);
  out.write_integer({"step", "steps made"}, state.step);
  out.write_number({"driving_gradient", "mean over the last step, rho U_b^2 / h"}, state.driving_gradient);
  out.create_group("grid");
  std::vector<double> faces;
  for (int j = 0; j <= setup.grid.ny; ++j) faces.push_back(setup.grid.y_face[j]);
  out.write_values({"grid/y_face", "heights of the cell faces, h"}, faces);
  out.create_group("fields");
  for (const time::NamedField& f : time::fields_of(state)) {
    out.write_field({"fields/" + f.name, f.description}, *f.field, f.rows, setup.grid);
  }
  out.create_group("statistics");
  out.write_values({"statistics/accumulators", "sums of all blocks, as the solver packs them"},
                   record.statistics);
  for (const auto& [name, sums] : record.spectra)
    out.write_values_of_root({"statistics/" + name, "sums of " + name + ", as the solver packs them"}, sums);
  out.create_group("diagnostics");
  out.write_number(
      {"diagnostics/limited_cells", "cells in which B was limited or the map torn, summed over steps"},
      record.limited_cells);
  out.write_number({"diagnostics/limited_since_step", "step since which they are counted"},
                   record.limited_since_step);
  out.write_number({"diagnostics/solid_volume_at_start", "sum of phi dV at time 0, h^3"},
                   record.solid_volume_at_start);
  out.close();
}

/// Digest of the file as it lies on disk; each rank reads its share of the pieces.
std::uint64_t shared_digest(const std::filesystem::path& file, std::int64_t bytes,
                            const parallel::Communicator& all) {
  const auto ranks = static_cast<std::size_t>(all.size()), rank = static_cast<std::size_t>(all.rank());
  std::vector<std::uint64_t> mine(digest_pieces(bytes)), pieces(mine.size());
  agree(all, ExitCode::kIoFailure, [&] {
    for (std::size_t piece = rank; piece < mine.size(); piece += ranks) {
      mine[piece] = digest_piece_of_file(file, piece);
    }
  });
  parallel::check(MPI_Allreduce(mine.data(), pieces.data(), static_cast<int>(mine.size()), MPI_UINT64_T,
                                MPI_BOR, all.get()),
                  "MPI_Allreduce");
  return combine_digests(pieces);
}

CheckpointHeader header_for(const Author& author, const time::State& state, const time::Setup& setup) {
  const auto& g = setup.grid;
  CheckpointHeader header;
  header.precision = name_of(grid::kPrecision);
  header.case_id = author.case_id;
  header.step = state.step;
  header.time = state.time;
  header.grid = {g.nx_global, g.ny, g.nz_global};
  header.length = {g.length_x, g.height, g.length_z};
  header.git_revision = build_info().git_revision;
  header.attempt = author.attempt;
  header.ranks = setup.decomposition.all().size();
  return header;
}

std::int64_t file_size(const std::filesystem::path& file, const parallel::Communicator& all) {
  std::int64_t bytes = 0;
  agree_on_root(all, ExitCode::kIoFailure,
                [&] { bytes = static_cast<std::int64_t>(std::filesystem::file_size(file)); });
  parallel::check(MPI_Bcast(&bytes, 1, MPI_INT64_T, 0, all.get()), "MPI_Bcast");
  return bytes;
}

}  // namespace

std::int64_t checkpoint_bytes(time::State& state, const grid::Grid& g) {
  std::int64_t rows = 0;
  for (const time::NamedField& f : time::fields_of(state)) rows += f.rows;
  return rows * g.nx_global * g.nz_global * std::int64_t{sizeof(grid::Real)};
}

std::filesystem::path write_checkpoint(const RunFiles& run, const Author& author, time::State& state,
                                       const CheckpointContents& record, const time::Setup& setup) {
  const auto& all = setup.decomposition.all();
  if (!time::is_finite(state, setup.decomposition)) {
    throw AgreedError(ExitCode::kDiverged, "the state at step " + std::to_string(state.step) +
                                               " holds numbers that are not finite");
  }
  const auto file = run.checkpoint(state.step);
  auto temporary = file;
  temporary += ".tmp";
  const Watchdog watchdog(Watchdog::seconds_for(checkpoint_bytes(state, setup.grid)));
  agree_on_root(all, ExitCode::kIoFailure, [&] { std::filesystem::create_directories(run.checkpoints()); });
  write_contents(temporary, state, record, setup);
  CheckpointHeader header = header_for(author, state, setup);
  header.bytes = file_size(temporary, all);
  header.xxh3 = shared_digest(temporary, header.bytes, all);
  agree_on_root(all, ExitCode::kIoFailure, [&] {
    write_header(temporary, header);
    publish_file(temporary, file);
  });
  return file;
}

}  // namespace softwall::output
