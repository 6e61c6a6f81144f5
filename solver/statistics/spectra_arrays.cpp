#include "solver/statistics/spectra_arrays.hpp"

#include <algorithm>
#include <string>

#include "solver/case/time_comparison.hpp"
#include "solver/statistics/energy_budget.hpp"
#include "solver/statistics/interface_moments.hpp"
#include "solver/statistics/interface_pairs.hpp"

namespace softwall::statistics {

namespace {

void append_blocks(const std::string& group, const MergingBlocks& blocks, double last_sample,
                   Arrays& arrays) {
  std::vector<double> start, end, weight;
  const BlockSchedule schedule = blocks.schedule();
  for (const auto& block : blocks.all()) {
    start.push_back(schedule.start + double(block.index) * schedule.length);
    end.push_back(start.back() + schedule.length);
    weight.push_back(block.sampled);
  }
  if (!end.empty() && !has_reached(last_sample, end.back())) end.back() = last_sample;
  const std::vector<std::size_t> shape{start.size()};
  arrays.push_back({group, "start", "h/U_b", "time at which the block starts", shape, start, true});
  arrays.push_back({group, "end", "h/U_b", "time at which the block ends", shape, end, true});
  arrays.push_back({group, "weight", "h/U_b", "time sampled within the block", shape, weight, true});
}

/// The numbers [first, first + n) of every block, divided by its weight.
std::vector<double> means(const MergingBlocks& blocks, std::size_t first, std::size_t n) {
  std::vector<double> values;
  for (const auto& block : blocks.all()) {
    for (std::size_t v = first; v < first + n; ++v) values.push_back(block.sums[v] / block.sampled);
  }
  return values;
}

/// What append_spectra() makes of the sums of all blocks: an array for each axis and field, and one for the
/// interface.
class SpectraByName {
 public:
  SpectraByName(const FlowSpectra& flow, std::size_t rows, std::size_t blocks, bool elastic) : rows_(rows) {
    const char* const axes[] = {"x", "z"};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto modes = static_cast<std::size_t>(flow.modes()[axis]);
      const std::string along = std::string(" by mode along ") + axes[axis];
      for (const auto field : FlowSpectra::kFields) {
        const std::string name(field);
        arrays_.push_back(
            {"spectra",
             axes[axis] + ("_" + name),
             name == "p" ? "rho^2 U_b^4" : "U_b^2",
             "mean square of " + name + along + " and row" + (name == "v" ? " of y_face" : " of y_center"),
             {blocks, modes, rows},
             {}});
        modes_.push_back(modes);
      }
      heights_.push_back({"spectra",
                          axes[axis] + std::string("_eta"),
                          "h^2",
                          "mean square of the height of the interface" + along,
                          {blocks, modes},
                          {}});
    }
    if (!elastic) heights_.clear();
  }

  /// `whole`: as FlowSpectra::whole() returns it.
  void add(const std::vector<double>& whole, double weight) {
    auto value = whole.begin();
    for (std::size_t n = 0; n < arrays_.size(); ++n) {
      const bool is_v = n % FlowSpectra::kFields.size() == 1;
      for (std::size_t mode = 0; mode < modes_[n]; ++mode) {
        for (std::size_t row = 0; row < rows_; ++row) {
          const double mean = *value++ / weight;
          const bool is_eta = is_v && row == 0;
          arrays_[n].values.push_back(is_eta ? 0 : mean);
          if (is_eta && !heights_.empty()) heights_[n / FlowSpectra::kFields.size()].values.push_back(mean);
        }
      }
    }
  }

  void append_to(Arrays& arrays) const {
    arrays.insert(arrays.end(), arrays_.begin(), arrays_.end());
    arrays.insert(arrays.end(), heights_.begin(), heights_.end());
  }

 private:
  std::size_t rows_;
  std::vector<std::size_t> modes_;
  Arrays arrays_, heights_;
};

}  // namespace

void append_grid(const time::Setup& setup, Arrays& arrays) {
  const auto& g = setup.grid;
  std::vector<double> center, face;
  for (int j = 0; j < g.ny; ++j) center.push_back(g.y_center[j]);
  for (int j = 0; j <= g.ny; ++j) face.push_back(g.y_face[j]);
  const auto add = [&arrays](const char* name, const char* description, const std::vector<double>& values) {
    arrays.push_back({"grid", name, "h", description, {values.size()}, values, true});
  };
  add("y_center", "wall-normal position of the cell centers", center);
  add("y_face", "wall-normal position of the cell faces, walls included", face);
  add("length", "periods in x and z", {g.length_x, g.length_z});
  add("columns", "cells in x and z", {double(g.nx_global), double(g.nz_global)});
  add("interface_y", "height of the flat interface, or of the upper wall", {g.y_face[g.ny_fluid]});
}

void append_spectra(const FlowSpectra& flow, const MergingBlocks& blocks, double last_sample,
                    const time::Setup& setup, Arrays& arrays) {
  append_blocks("spectra", blocks, last_sample, arrays);
  SpectraByName by_name(flow, static_cast<std::size_t>(setup.grid.ny), blocks.all().size(),
                        setup.solid.has_value());
  for (const auto& block : blocks.all()) {
    const auto whole = flow.whole(block.sums);
    if (!whole.empty()) by_name.add(whole, block.sampled);
  }
  if (setup.decomposition.all().rank() == 0) by_name.append_to(arrays);
}

void append_budget(const MergingBlocks& blocks, double last_sample, const time::Setup& setup,
                   Arrays& arrays) {
  const auto rows = static_cast<std::size_t>(setup.grid.ny);
  append_blocks("budget", blocks, last_sample, arrays);
  for (std::size_t n = 0; n < kBudgetKinds.size(); ++n) {
    const BudgetKind& kind = kBudgetKinds[n];
    arrays.push_back({"budget",
                      std::string(kind.name),
                      std::string(kind.unit),
                      "plane mean by row: " + std::string(kind.description),
                      {blocks.all().size(), rows},
                      means(blocks, n * rows, rows),
                      true});
  }
}

void append_interface(const MergingBlocks& blocks, double last_sample, const time::Setup& setup,
                      Arrays& arrays) {
  const std::size_t count = blocks.all().size();
  append_blocks("interface", blocks, last_sample, arrays);
  for (std::size_t n = 0; n < kInterfaceMoments.size(); ++n) {
    arrays.push_back({"interface",
                      std::string(kInterfaceMoments[n]),
                      "h, U_b, rho",
                      "plane mean of this product of fluctuations at the mean interface",
                      {count},
                      means(blocks, n, 1),
                      true});
  }
  const auto edges = height_bin_edges(setup.grid);
  arrays.push_back(
      {"interface", "bin_edges", "h", "bounds of the bins of share", {edges.size()}, edges, true});
  arrays.push_back({"interface",
                    "share",
                    "1",
                    "part of the interface whose height less its mean lies in a bin",
                    {count, std::size_t{kHeightBins}},
                    means(blocks, kInterfaceMoments.size(), kHeightBins)});
}

void append_pairs(const MergingBlocks& blocks, double last_sample, const time::Setup& setup, Arrays& arrays) {
  constexpr std::size_t kBins{kPairBins};
  append_blocks("interface_pairs", blocks, last_sample, arrays);
  for (std::size_t n = 0; n < kInterfacePairs.size(); ++n) {
    const std::string first(kInterfacePairs[n].first), second(kInterfacePairs[n].second);
    arrays.push_back({"interface_pairs",
                      "share_" + first + "_" + second,
                      "1",
                      "part of the mean interface where the fluctuation of " + first +
                          " (first) lies in one bin and that of " + second + " in another",
                      {blocks.all().size(), kBins, kBins},
                      means(blocks, n * kBins * kBins, kBins * kBins)});
  }
  for (const auto quantity : kBinnedQuantities) {
    const auto edges = pair_bin_edges(quantity, setup.grid);
    const std::string name(quantity);
    arrays.push_back({"interface_pairs",
                      "edges_" + name,
                      name == "v"   ? "U_b"
                      : name == "p" ? "rho U_b^2"
                                    : "h",
                      "bounds of the bins of " + name + "; what lies beyond is in the last one",
                      {edges.size()},
                      edges,
                      true});
  }
}

void append_waves(const InterfaceModes& waves, Arrays& arrays) {
  const std::size_t length = waves.row_length(), moments = waves.rows().size() / length;
  std::vector<double> time, real, imaginary;
  for (std::size_t n = 0; n < moments; ++n) {
    const double* const row = &waves.rows()[n * length];
    time.push_back(row[0]);
    for (std::size_t m = 0; m < waves.modes(); ++m) {
      real.push_back(row[1 + 2 * m]);
      imaginary.push_back(row[2 + 2 * m]);
    }
  }
  const std::vector<std::size_t> shape{moments, waves.modes()};
  const std::string what =
      " part of the mean of (eta - its mean) exp(-i k x), k = 2 pi m / length_x, m = 1, 2, ...";
  arrays.push_back({"interface_waves", "time", "h/U_b", "of the moments", {moments}, time, true});
  arrays.push_back({"interface_waves", "real", "h", "real" + what, shape, real, true});
  arrays.push_back({"interface_waves", "imaginary", "h", "imaginary" + what, shape, imaginary, true});
}

}  // namespace softwall::statistics
