#include "campaign/core/machine.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "campaign/core/words.hpp"
#include "solver/case/rank_sharing.hpp"

namespace softwall::campaign {
namespace {

/// Memory of a rank before it has any field: program, MPI and HDF5 (measured: 16 x 16 x 16 cells took 45 MB).
constexpr double kRankBytes = 45e6;

/// Numbers of the fields' precision and bytes besides that a solver holds for each cell; measured as the
/// largest resident memory of 64 x 64 x 64 (+ 16) cells in both precisions: 138 and 78 B a cell without a
/// solid, 264 and 146 with the reference map, 293 and 163 with transported B.
struct PerCell {
  double numbers, bytes;
};

PerCell per_cell(const Physics& physics) {
  if (!physics.solid) return {15, 18};
  return physics.solid->formulation == SolidFormulation::kReferenceMap ? PerCell{29.5, 28}
                                                                       : PerCell{32.5, 33};
}

}  // namespace

double memory_bytes(const Case& c, int ranks) {
  const Physics& physics = c.physics;
  const GridSpec& grid = physics.grid;
  const double number = physics.precision == Precision::kSingle ? sizeof(float) : sizeof(double);
  const PerCell each = per_cell(physics);
  const double cells = static_cast<double>(grid.nx) * grid.ny() * grid.nz;
  return ranks * kRankBytes + cells * (each.numbers * number + each.bytes);
}

std::vector<Mistake> obstacles(const CampaignCase& one, const Execution& execution, const Machine& machine) {
  std::vector<Mistake> found;
  const std::string where = one.is_precursor ? "/execution/precursor_ranks" : "/execution/ranks";
  const int cores = execution.cores > 0 ? execution.cores : machine.cores;
  if (one.ranks > cores) {
    found.push_back({where, std::to_string(one.ranks),
                     "this machine has " + counted(cores, "core") + "; execution.cores may say otherwise"});
  }
  const GridSpec& grid = one.definition.physics.grid;
  if (const std::string problem = sharing_problem(one.ranks, grid.nx, grid.nz); !problem.empty())
    found.push_back({where, std::to_string(one.ranks), problem});
  const std::string precision = name_of(one.definition.physics.precision);
  if (const auto missing = machine.missing_programs.find(precision);
      missing != machine.missing_programs.end()) {
    found.push_back({"/physics/precision", precision,
                     "its solver, built beside softwall-dns, is not there: " + missing->second});
  }
  const double needed = memory_bytes(one.definition, one.ranks);
  if (machine.memory_bytes > 0 && needed > machine.memory_bytes) {
    found.push_back({"/physics/grid", "takes about " + gigabytes(needed) + " of memory",
                     "this machine has " + gigabytes(machine.memory_bytes)});
  }
  return found;
}

std::string gigabytes(double bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g GB", bytes / 1e9);
  return text.data();
}

}  // namespace softwall::campaign
