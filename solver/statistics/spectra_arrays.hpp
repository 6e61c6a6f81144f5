#pragma once

#include <vector>

#include "solver/run_directory/array_file.hpp"
#include "solver/statistics/flow_spectra.hpp"
#include "solver/statistics/interface_modes.hpp"
#include "solver/statistics/merging_blocks.hpp"
#include "solver/time/setup.hpp"

/// What Spectra has summed, as the arrays of spectra.h5 (output/README.md lists them).
namespace softwall::statistics {

using Arrays = std::vector<analysis::NamedArray>;

/// Heights of cells and faces, periods of the box, height of the flat interface.
void append_grid(const time::Setup& setup, Arrays& arrays);

/// `last_sample`: time up to which a block that is still open has been seen. Collective; complete on rank 0.
void append_spectra(const FlowSpectra& flow, const MergingBlocks& blocks, double last_sample,
                    const time::Setup& setup, Arrays& arrays);

void append_budget(const MergingBlocks& blocks, double last_sample, const time::Setup& setup, Arrays& arrays);

void append_interface(const MergingBlocks& blocks, double last_sample, const time::Setup& setup,
                      Arrays& arrays);

void append_pairs(const MergingBlocks& blocks, double last_sample, const time::Setup& setup, Arrays& arrays);

void append_waves(const InterfaceModes& waves, Arrays& arrays);

}  // namespace softwall::statistics
