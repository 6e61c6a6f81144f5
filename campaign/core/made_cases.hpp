#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/core/swept_parameters.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {

/// The cases of one kind, precursors or those of the sweep, as they come from its points: equal ones are
/// kept once, and in the end each is given a label that says in what it differs from the others.
class MadeCases {
 public:
  explicit MadeCases(const SweptParameters& swept) : swept_(swept) {}

  void reserve(std::size_t number);
  [[nodiscard]] bool empty() const { return list_.empty(); }
  /// values: by swept parameter, as the sweep set them.
  void add(CampaignCase made, std::vector<nlohmann::json> values);
  /// Two cases may differ by name alone: in members that change nothing as the others are. To be noted before
  /// the case with these physics is added.
  void note_idle(nlohmann::json physics, const std::vector<nlohmann::json>& values);
  /// One mistake for each swept parameter whose values gave the same case, by its pointer.
  [[nodiscard]] const std::map<std::string, Mistake>& merged() const { return merged_; }

  /// Labels of what varies; where nothing does, of what the sweep sets. first: the word they begin with.
  void name(const std::string& first);
  [[nodiscard]] std::vector<CampaignCase> take() { return std::move(list_); }

 private:
  void note_merged(const std::vector<nlohmann::json>& first, const std::vector<nlohmann::json>& second);
  [[nodiscard]] std::vector<bool> varying(bool also_the_same) const;

  const SweptParameters& swept_;
  std::vector<CampaignCase> list_;
  std::vector<std::vector<nlohmann::json>> values_;         ///< [case][swept parameter]
  std::unordered_map<std::string, std::size_t> index_;      ///< by id
  std::unordered_map<std::string, std::size_t> by_effect_;  ///< by the id without what changes nothing
  std::map<std::string, Mistake> merged_;
};

}  // namespace softwall::campaign
