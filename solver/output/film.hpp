#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/output/cell_plane.hpp"
#include "solver/output/collection.hpp"
#include "solver/run_directory/array_file.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::output {

/// The film of a run: planes of the flow and the height of the interface, a small file each moment. Not part
/// of the state.
class Film {
 public:
  Film(RunFiles run, const Case& definition, const time::Setup& setup);

  /// Whether there is nothing to write: no plane is asked for, and no layer has an interface.
  [[nodiscard]] bool none() const { return planes_.empty() && !has_layer_; }

  /// Whether a layer's interface is in it.
  [[nodiscard]] bool has_layer() const { return has_layer_; }

  /// Writes planes/planes-<step>.h5, the same bytes on any number of ranks for the same state: of each plane
  /// u, v, w, p and, with a solid, phi at the cell centres in single precision, and with a layer the height
  /// of its interface; and takes it up in planes/planes.xdmf. A file that already exists is replaced.
  /// heights: of the interface over this rank's columns, i + nx k, h (statistics/interface_height.hpp); not
  /// looked at without a layer. Collective. Throws AgreedError (75) where it cannot be written.
  void write(const time::State& state, const std::vector<double>& heights);

  /// Removes the files of later steps (collection.hpp). On one rank.
  void remove_later_than(std::int64_t step) { collection_.remove_later_than(run_.planes_of(step)); }

 private:
  struct Named {
    std::string name;  ///< of its group: "y_0" for the first of those asked for across y
    CellPlane plane;
  };

  void add_plane(const Named& one, const time::State& state, std::vector<analysis::NamedArray>& arrays) const;
  void add_interface(const std::vector<double>& heights, std::vector<analysis::NamedArray>& arrays) const;

  RunFiles run_;
  std::string case_id_;
  const time::Setup& setup_;
  bool has_layer_;
  std::vector<Named> planes_;
  Collection collection_;
};

}  // namespace softwall::output
