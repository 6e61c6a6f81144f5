#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "solver/case/case.hpp"

namespace softwall::campaign {

/// What a campaign leaves open about a case, so that one which is there already may settle it.
struct Continuation {
  StatisticsSpec statistics;  ///< what it samples
  double dt_plus = 0;         ///< solid.dt_plus; 0 where there is no solid
};

/// Cases that have run directories, to be found again by a campaign that wants other averages of the same
/// flow, or whose file was written for an earlier version. A new case keeps blocks of statistics from t = 0,
/// and the averaging window is chosen when its results are made. Cases of earlier versions began their blocks
/// at statistics.start_time, which is a part of their ids; they keep both, and serve wherever their blocks
/// can. Nor did they know solid.dt_plus; where the campaign's file does not ask for it, they go on without.
class ExistingCases {
 public:
  /// physics: of its case.json, valid and with all defaults, here and below.
  void add(const nlohmann::json& physics);
  [[nodiscard]] bool empty() const { return by_flow_.empty(); }

  /// What a case with these physics is to sample, and how long its steps may be: as an existing case of the
  /// same flow whose blocks can be merged into blocks of the length wanted, else the length wanted from t =
  /// 0. Preferred is one with the steps wanted, then one that began no later than the window wanted, then one
  /// with the same blocks. Others have other steps only if `any_steps`.
  [[nodiscard]] Continuation continuation_of(const nlohmann::json& physics, bool any_steps) const;

 private:
  std::multimap<std::string, Continuation> by_flow_;  ///< by the id that the case would have without them
};

}  // namespace softwall::campaign
