#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "solver/case/case.hpp"

namespace softwall::campaign {

/// Cases that have run directories, to be found again by a campaign that wants other averages of the same
/// flow. A new case keeps blocks of statistics from t = 0, and the averaging window is chosen when its
/// results are made. Cases of earlier versions began their blocks at statistics.start_time, which is a part
/// of their ids; they keep both, and serve wherever their blocks can.
class ExistingCases {
 public:
  /// physics: of its case.json, valid and with all defaults, here and below.
  void add(const nlohmann::json& physics);
  [[nodiscard]] bool empty() const { return by_flow_.empty(); }

  /// The statistics that a case with these physics is to sample: those of an existing case of the same flow
  /// whose blocks can be merged into blocks of the length wanted, else the length wanted from t = 0.
  /// Preferred is one that began no later than the window wanted, then one with the same blocks.
  [[nodiscard]] StatisticsSpec statistics_for(const nlohmann::json& physics) const;

 private:
  std::multimap<std::string, StatisticsSpec> by_flow_;  ///< by the id that the case would have without them
};

}  // namespace softwall::campaign
