#include "campaign/core/expand.hpp"

#include <algorithm>
#include <map>

#include "campaign/core/case_mistakes.hpp"
#include "campaign/core/effect.hpp"
#include "campaign/core/label.hpp"
#include "campaign/core/parameters.hpp"
#include "campaign/core/sweep.hpp"
#include "solver/case/case_id.hpp"
#include "solver/case/case_json.hpp"
#include "solver/case/case_schema.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

json document_of(json physics, json run) {
  json document = json::object();
  document["format"] = 1;
  document["label"] = "";
  document["physics"] = std::move(physics);
  document["run"] = std::move(run);
  return document;
}

json with_defaults(json document) {
  case_schema().fill_defaults(document);
  return document;
}

/// The rigid channel before a wall is made elastic shares its fluid and its start with the elastic case, not
/// its numerics.
bool concerns_precursor(const std::string& pointer) {
  return pointer == "/reynolds" || pointer == "/domain/length_x" || pointer == "/domain/length_z" ||
         pointer == "/initial/seed" || pointer == "/initial/amplitude" ||
         (pointer.starts_with("/grid/") && pointer != "/grid/ny_solid");
}

void put(const Point& point, json& physics) {
  for (const auto& [pointer, value] : point) physics[Pointer(pointer)] = value;
}

/// Gives an elastic wall the campaign's default of solid.dt_plus, which is not that of a case. Returns
/// whether the campaign's file left it open.
bool limit_steps(json& physics) {
  const Pointer dt_plus("/solid/dt_plus"), fixed_dt("/time_step/fixed_dt");
  if (physics.at("flow") != "elastic_wall" || !physics.contains("solid") || physics.contains(dt_plus) ||
      physics.contains(fixed_dt))
    return false;
  physics[dt_plus] = campaign_schema().part(Pointer("/physics/solid/dt_plus"))->at("default");
  return true;
}

class Expansion {
 public:
  Expansion(const CampaignSpec& spec, const ExistingCases& existing)
      : spec_(spec),
        existing_(existing),
        points_(sweep_points(spec.sweep)),
        swept_(swept_pointers(points_)),
        exclusions_(spec.sweep.at("exclude")) {}

  Campaign run() {
    cases_.list.reserve(points_.size());
    cases_.values.reserve(points_.size());
    for (const auto& point : points_) add(point);
    mistakes_.throw_if_any(spec_.source, points_.size());
    if (cases_.list.empty())
      throw BadInput(spec_.source, {{"/sweep/exclude", "excludes every case", "leave some"}});
    auto without_effect = exclusions_.unused();
    for (auto& [pointer, mistake] : merged_) without_effect.push_back(std::move(mistake));
    if (!without_effect.empty()) throw BadInput(spec_.source, std::move(without_effect));
    name(precursors_, "precursor");
    name(cases_, "");
    Campaign campaign{spec_.name, spec_.description, std::move(precursors_.list), spec_.execution,
                      spec_.text};
    campaign.cases.reserve(campaign.cases.size() + cases_.list.size());
    for (auto& c : cases_.list) campaign.cases.push_back(std::move(c));
    make_labels_distinct(campaign);
    return campaign;
  }

 private:
  /// Cases of one kind with what the sweep sets in them.
  struct Made {
    std::vector<CampaignCase> list;
    std::vector<std::vector<json>> values;     ///< [case][swept pointer]; null: the case has no such member
    std::map<std::string, std::size_t> index;  ///< by id
  };

  /// A case before it has been checked.
  struct Candidate {
    json written, filled;      ///< the document, without and with defaults
    std::vector<json> values;  ///< by swept pointer, before it was made to start from a precursor
    std::string precursor_id;
    bool any_steps;  ///< the campaign does not say how long its steps may be
  };

  void add(const Point& point) {
    json physics = spec_.physics;
    put(point, physics);
    if (!physics.contains("flow"))
      physics["flow"] = campaign_schema().part(Pointer("/physics/flow"))->at("default");
    const bool any_steps = limit_steps(physics);
    json document = document_of(std::move(physics), spec_.run);
    json filled = with_defaults(document);
    const json& wanted = filled.at("physics");
    if (exclusions_.excludes(wanted)) return;
    std::vector<json> values = values_of(wanted);
    std::string precursor_id;
    if (!spec_.precursor.is_null()) {
      precursor_id = add_precursor(point);
      document["physics"]["initial"] = {{"type", "precursor"},
                                        {"precursor", precursor_id},
                                        {"precursor_time", spec_.precursor.at("run").at("end_time")}};
      filled = with_defaults(document);
    }
    add_case({std::move(document), std::move(filled), std::move(values), precursor_id, any_steps}, cases_);
  }

  /// Id of the precursor that this point's case starts from; made if no earlier point needed the same.
  std::string add_precursor(const Point& point) {
    json physics = spec_.physics;
    Point fluid;
    for (const auto& [pointer, value] : point)
      if (concerns_precursor(pointer)) fluid[pointer] = value;
    put(fluid, physics);
    physics["flow"] = "rigid_channel";
    physics.erase("solid");
    physics["grid"].erase("ny_solid");
    if (physics.contains("domain")) physics["domain"].erase("layer_height");
    json run = spec_.run;
    for (const auto& [key, value] : spec_.precursor.items())
      (key == "run" ? run : physics[key]).merge_patch(value);
    json document = document_of(std::move(physics), std::move(run));
    json filled = with_defaults(document);
    std::vector<json> values = values_of(filled.at("physics"));
    return add_case({std::move(document), std::move(filled), std::move(values), "", false}, precursors_);
  }

  /// Checks a case and appends it unless it is there already. Returns its id.
  std::string add_case(Candidate candidate, Made& to) {
    auto& [written, document, values, precursor_id, any_steps] = candidate;
    const bool is_precursor = &to == &precursors_;
    const auto refuse = [&, &swept = values](std::vector<Mistake> found) {
      mistakes_.add(swept_label(swept), is_precursor ? "/precursor: " : "", std::move(found));
      return std::string(16, '0');  // lets the cases that start from it be checked all the same
    };
    if (auto found = case_mistakes(written); !found.empty()) return refuse(std::move(found));
    CampaignCase made;
    made.window_start = document.at("physics").at("statistics").at("start_time");
    continue_existing(document.at("physics"), any_steps);
    if (auto never = never_sampled(document, made.window_start)) return refuse({*never});
    made.definition = valid_case(document);
    made.is_precursor = is_precursor;
    made.precursor_id = precursor_id;
    made.ranks = is_precursor ? spec_.execution.precursor_ranks : spec_.execution.ranks;
    const std::string id = made.definition.id;
    const auto [known, is_new] = to.index.emplace(id, to.list.size());
    if (is_new) {
      to.list.push_back(std::move(made));
      to.values.push_back(std::move(values));
    } else if (!is_precursor) {
      note_merged(to.values[known->second], values);
    }
    return id;
  }

  /// What a case samples does not depend on the averaging window that is wanted of it now, and the steps of
  /// one that an earlier version began stay what they were.
  void continue_existing(json& physics, bool any_steps) const {
    const Continuation found = existing_.continuation_of(physics, any_steps);
    physics["statistics"]["start_time"] = found.statistics.start_time;
    physics["statistics"]["block_length"] = found.statistics.block_length;
    if (physics.contains("solid")) physics["solid"]["dt_plus"] = found.dt_plus;
  }

  /// Two points of the sweep are one case although they differ: what they differ in has no effect.
  void note_merged(const std::vector<json>& first, const std::vector<json>& second) {
    for (std::size_t i = 0; i < swept_.size(); ++i) {
      if (first[i] == second[i] || merged_.contains(swept_[i])) continue;
      merged_[swept_[i]] = {
          "/sweep: " + swept_[i].substr(1), quoted(first[i]) + " and " + quoted(second[i]),
          "give the same case: this parameter has no effect here, leave it out of the sweep"};
    }
  }

  [[nodiscard]] std::vector<json> values_of(const json& physics) const {
    std::vector<json> values;
    for (const auto& pointer : swept_)
      values.push_back(physics.contains(Pointer(pointer)) ? physics.at(Pointer(pointer)) : json());
    return values;
  }

  /// "G=1_mu=10": all that the sweep sets, for messages.
  [[nodiscard]] std::string swept_label(const std::vector<json>& values) const {
    return label_of(named(values, std::vector<bool>(swept_.size(), true)));
  }

  [[nodiscard]] std::vector<std::pair<std::string, json>> named(const std::vector<json>& values,
                                                                const std::vector<bool>& chosen) const {
    std::vector<std::pair<std::string, json>> parameters;
    for (std::size_t i = 0; i < swept_.size(); ++i)
      if (chosen[i] && !values[i].is_null()) parameters.emplace_back(Pointer(swept_[i]).back(), values[i]);
    return parameters;
  }

  /// Gives every case a label that says in what it differs from the others; where nothing differs, what the
  /// sweep sets.
  void name(Made& made, const std::string& first) const {
    std::vector<bool> varies(swept_.size(), false);
    for (const auto& values : made.values)
      for (std::size_t i = 0; i < swept_.size(); ++i) varies[i] = varies[i] || values[i] != made.values[0][i];
    const bool single = std::find(varies.begin(), varies.end(), true) == varies.end();
    if (single && first.empty()) varies.assign(swept_.size(), true);
    for (std::size_t c = 0; c < made.list.size(); ++c) {
      const auto parameters = named(made.values[c], varies);
      std::string label = parameters.empty() ? "" : label_of(parameters);
      if (!first.empty()) label = first + (label.empty() ? "" : "_" + label);
      if (label.empty()) label = to_json(made.list[c].definition).at("physics").at("flow");
      made.list[c].definition.label = label;
      nlohmann::ordered_json varied = nlohmann::ordered_json::object();
      for (const auto& [parameter, value] : parameters) varied[parameter] = value;
      made.list[c].varied = varied.dump();
    }
  }

  const CampaignSpec& spec_;
  const ExistingCases& existing_;
  std::vector<Point> points_;
  std::vector<std::string> swept_;
  ExclusionUse exclusions_;
  Made precursors_, cases_;
  std::map<std::string, Mistake> merged_;  ///< by the pointer of the parameter
  CaseMistakes mistakes_;
};

}  // namespace

Campaign expand(const CampaignSpec& spec, const ExistingCases& existing) {
  return Expansion(spec, existing).run();
}

}  // namespace softwall::campaign
