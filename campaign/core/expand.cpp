#include "campaign/core/expand.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>

#include "campaign/core/case_mistakes.hpp"
#include "campaign/core/derive.hpp"
#include "campaign/core/effect.hpp"
#include "campaign/core/label.hpp"
#include "campaign/core/parameters.hpp"
#include "campaign/core/sweep.hpp"
#include "solver/case/case_checks.hpp"
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

constexpr const char* kDtPlus = "/solid/dt_plus";
constexpr const char* kFixedDt = "/time_step/fixed_dt";

/// Gives an elastic wall the campaign's default of solid.dt_plus, which is not that of a case.
void limit_steps(json& physics) {
  physics[Pointer(kDtPlus)] = campaign_schema().part(Pointer("/physics/solid/dt_plus"))->at("default");
}

std::vector<Pointer> compiled(const std::vector<std::string>& pointers) {
  return {pointers.begin(), pointers.end()};
}

/// Decides by the values that a point sets whether its case is valid by the schema, once another point that
/// sets the same members has shown that the rest is. The schema judges every member by itself, so this is
/// what it would say of the whole document, which differs in these values alone.
class SoundValues {
 public:
  [[nodiscard]] bool covers(const Point& point) {
    return sound_.contains(members_of(point)) && std::ranges::all_of(point, [&](const auto& item) {
             return schema_of(item.first).mistakes(item.second).empty();
           });
  }
  void note_sound(const Point& point) { sound_.insert(members_of(point)); }

 private:
  static std::string members_of(const Point& point) {
    std::string members;
    for (const auto& [pointer, value] : point) members += pointer + "\n";
    return members;
  }
  const JsonSchema& schema_of(const std::string& pointer) {
    const auto known = schemas_.find(pointer);
    if (known != schemas_.end()) return known->second;
    return schemas_.emplace(pointer, case_schema().part(Pointer("/physics" + pointer))->dump()).first->second;
  }

  std::set<std::string> sound_;  ///< the members set by points whose case was sound
  std::map<std::string, JsonSchema> schemas_;
};

class Expansion {
 public:
  Expansion(const CampaignSpec& spec, const ExistingCases& existing)
      : spec_(spec),
        existing_(existing),
        points_(sweep_points(spec.sweep)),
        derivation_(spec.derive),
        swept_(set_pointers(points_, derivation_)),
        swept_places_(compiled(swept_)),
        exclusions_(spec.sweep.at("exclude")),
        common_(document_of(physics_with_flow(spec.physics), spec.run)),
        filled_(with_defaults(common_)) {}

  Campaign run() {
    cases_.list.reserve(points_.size());
    cases_.values.reserve(points_.size());
    for (const auto& point : points_) add(point);
    mistakes_.throw_if_any(spec_.source, points_.size());
    if (cases_.list.empty())
      throw BadInput(spec_.source, {{"/sweep/exclude", "excludes every case", "leave some"}});
    auto without_effect = exclusions_.unused();
    for (auto& mistake : derivation_.without_effect()) without_effect.push_back(std::move(mistake));
    for (auto& [pointer, mistake] : merged_) without_effect.push_back(std::move(mistake));
    if (!without_effect.empty()) throw BadInput(spec_.source, std::move(without_effect));
    name(precursors_, "precursor");
    name(cases_, "");
    Campaign campaign{.name = spec_.name,
                      .description = spec_.description,
                      .cases = std::move(cases_.list),
                      .until = spec_.until,
                      .execution = spec_.execution,
                      .spec_text = spec_.text};
    campaign.cases.insert(campaign.cases.begin(), std::make_move_iterator(precursors_.list.begin()),
                          std::make_move_iterator(precursors_.list.end()));
    make_labels_distinct(campaign);
    return campaign;
  }

 private:
  /// Cases of one kind with what the sweep sets in them.
  struct Made {
    std::vector<CampaignCase> list;
    std::vector<std::vector<json>> values;  ///< [case][swept pointer]; null: it has no such member
    std::unordered_map<std::string, std::size_t> index;      ///< by id
    std::unordered_map<std::string, std::size_t> by_effect;  ///< by the id without what changes nothing
    SoundValues sound;
  };

  /// A case before it has been checked.
  struct Candidate {
    json filled;                    ///< the document with all defaults
    std::vector<json> values;       ///< by swept pointer, before it was made to start from a precursor
    std::function<json()> written;  ///< the document without defaults, which messages speak of
    std::string precursor_id;
    const Point& point;
    bool any_steps = false;  ///< the campaign does not say how long its steps may be
  };

  static json physics_with_flow(json physics) {
    if (!physics.contains("flow"))
      physics["flow"] = campaign_schema().part(Pointer("/physics/flow"))->at("default");
    return physics;
  }

  /// The defaults of what all cases have in common are filled in once. They are filled in again after the
  /// point's values have been put, because a point may bring in an object that has further members.
  void add(Point point) {
    if (!derivation_.empty() && !derive(point)) return;
    json filled = filled_;
    put(point, filled.at("physics"));
    const bool any_steps = leaves_steps_open(point, filled.at("physics"));
    if (any_steps) limit_steps(filled.at("physics"));
    case_schema().fill_defaults(filled);
    if (exclusions_.excludes(filled.at("physics"))) return;
    derivation_.note_effect(filled.at("physics"));
    std::vector<json> values = values_of(filled.at("physics"));
    std::string precursor_id;
    if (!spec_.precursor.is_null()) {
      precursor_id = precursor_for(point);
      start_from(precursor_id, filled);
      case_schema().fill_defaults(filled);
    }
    const auto written = [&] {
      json document = common_;
      put(point, document.at("physics"));
      if (any_steps) limit_steps(document.at("physics"));
      if (!precursor_id.empty()) start_from(precursor_id, document);
      return document;
    };
    add_case({.filled = std::move(filled),
              .values = std::move(values),
              .written = written,
              .precursor_id = precursor_id,
              .point = point,
              .any_steps = any_steps},
             cases_);
  }

  /// Puts into the point what follows from it. Where that cannot be, it is told, unless the point is
  /// excluded.
  bool derive(Point& point) {
    json filled = filled_;
    json& physics = filled.at("physics");
    put(point, physics);
    if (leaves_steps_open(point, physics)) limit_steps(physics);
    case_schema().fill_defaults(filled);
    auto found = derivation_.add_to(point, physics);
    if (found.empty()) return true;
    if (!exclusions_.excludes(physics)) mistakes_.add(swept_label(values_of(physics)), "", std::move(found));
    return false;
  }

  /// Whether the file says nothing about the steps of this elastic wall.
  [[nodiscard]] bool leaves_steps_open(const Point& point, const json& physics) const {
    const auto says = [&](const char* pointer) {
      return point.contains(pointer) || common_.at("physics").contains(Pointer(pointer));
    };
    return physics.at("flow") == "elastic_wall" && physics.contains("solid") && !says(kDtPlus) &&
           !says(kFixedDt);
  }

  void start_from(const std::string& precursor_id, json& document) const {
    document.at("physics")["initial"] = {{"type", "precursor"},
                                         {"precursor", precursor_id},
                                         {"precursor_time", spec_.precursor.at("run").at("end_time")}};
  }

  /// Id of the precursor that this point's case starts from; made if no earlier point needed the same.
  std::string precursor_for(const Point& point) {
    Point fluid;
    for (const auto& [pointer, value] : point)
      if (concerns_precursor(pointer)) fluid[pointer] = value;
    const auto [known, is_new] = precursor_ids_.try_emplace(fluid);
    if (is_new) known->second = add_precursor(fluid);
    return known->second;
  }

  std::string add_precursor(const Point& fluid) {
    json physics = spec_.physics;
    put(fluid, physics);
    physics["flow"] = "rigid_channel";
    physics.erase("solid");
    physics["grid"].erase("ny_solid");
    if (physics.contains("domain")) physics["domain"].erase("layer_height");
    json run = spec_.run;
    for (const auto& [key, value] : spec_.precursor.items())
      (key == "run" ? run : physics[key]).merge_patch(value);
    const json document = document_of(std::move(physics), std::move(run));
    json filled = with_defaults(document);
    std::vector<json> values = values_of(filled.at("physics"));
    return add_case({.filled = std::move(filled),
                     .values = std::move(values),
                     .written = [&] { return document; },
                     .precursor_id = "",
                     .point = fluid},
                    precursors_);
  }

  /// The mistakes of what was written. Defaults have none, nor does the schema require what has a default, so
  /// that the filled document of a sound case tells that it is one.
  static std::vector<Mistake> mistakes_of(const Candidate& candidate, SoundValues& sound) {
    auto found = sound.covers(candidate.point) ? case_cross_checks(candidate.filled, {})
                                               : case_mistakes(candidate.filled, candidate.filled);
    if (!found.empty()) return case_mistakes(candidate.written(), candidate.filled);
    sound.note_sound(candidate.point);
    return found;
  }

  /// Checks a case and appends it unless it is there already. Returns its id.
  std::string add_case(Candidate candidate, Made& to) {
    auto& [document, values, written, precursor_id, point, any_steps] = candidate;
    const bool is_precursor = &to == &precursors_;
    const auto refuse = [&, &swept = values](std::vector<Mistake> found) {
      mistakes_.add(swept_label(swept), is_precursor ? "/precursor: " : "", std::move(found));
      return std::string(16, '0');  // lets the cases that start from it be checked all the same
    };
    if (auto found = mistakes_of(candidate, to.sound); !found.empty()) return refuse(std::move(found));
    CampaignCase made;
    made.window_start = document.at("physics").at("statistics").at("start_time");
    continue_existing(document.at("physics"), any_steps);
    if (auto never = never_sampled(document, made.window_start)) return refuse({*never});
    made.definition = valid_case(document);
    made.is_precursor = is_precursor;
    made.precursor_id = precursor_id;
    if (!is_precursor) made.until = spec_.until;  // the end of a precursor is a part of what starts from it
    made.ranks = is_precursor ? spec_.execution.precursor_ranks : spec_.execution.ranks;
    const std::string id = made.definition.id;
    if (!is_precursor) note_idle(document.at("physics"), values, to);
    const auto [known, is_new] = to.index.emplace(id, to.list.size());
    if (is_new) {
      to.list.push_back(std::move(made));
      to.values.push_back(std::move(values));
    } else if (!is_precursor) {
      note_merged(to.values[known->second], values);
    }
    return id;
  }

  /// Two cases may differ by name alone: in members that change nothing as the others are.
  void note_idle(json physics, const std::vector<json>& values, Made& to) {
    std::vector<Pointer> idle;
    for (const std::string& pointer : members_without_effect(physics))
      if (std::ranges::binary_search(swept_, pointer)) idle.emplace_back(pointer);
    if (idle.empty()) return;
    for (const Pointer& pointer : idle) {
      json& object = physics.at(pointer.parent_pointer());
      if (object.is_object()) object.erase(pointer.back());
    }
    const auto [known, is_new] = to.by_effect.emplace(case_id(physics), to.list.size());
    if (!is_new && known->second < to.values.size()) note_merged(to.values[known->second], values);
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
      if (first[i] == second[i] || is_derived(i) || merged_.contains(swept_[i])) continue;
      merged_[swept_[i]] = {
          "/sweep: " + swept_[i].substr(1), quoted(first[i]) + " and " + quoted(second[i]),
          "give the same case: this parameter has no effect here, leave it out of the sweep"};
    }
  }

  [[nodiscard]] std::vector<json> values_of(const json& physics) const {
    std::vector<json> values;
    for (const auto& place : swept_places_)
      values.push_back(physics.contains(place) ? physics.at(place) : json());
    return values;
  }

  /// "G=1_mu=10": all that the sweep sets, for messages.
  [[nodiscard]] std::string swept_label(const std::vector<json>& values) const {
    return label_of(named(values, not_derived()));
  }

  [[nodiscard]] bool is_derived(std::size_t i) const {
    const auto derived = derivation_.pointers();
    return std::ranges::find(derived, swept_[i]) != derived.end();
  }

  [[nodiscard]] std::vector<bool> not_derived() const {
    std::vector<bool> chosen(swept_.size());
    for (std::size_t i = 0; i < swept_.size(); ++i) chosen[i] = !is_derived(i);
    return chosen;
  }

  [[nodiscard]] std::vector<std::pair<std::string, json>> named(const std::vector<json>& values,
                                                                const std::vector<bool>& chosen) const {
    std::vector<std::pair<std::string, json>> parameters;
    for (std::size_t i = 0; i < swept_.size(); ++i)
      if (chosen[i] && !values[i].is_null()) parameters.emplace_back(swept_places_[i].back(), values[i]);
    return parameters;
  }

  /// Gives every case a label that says in what it differs from the others; where nothing differs, what the
  /// sweep sets.
  void name(Made& made, const std::string& first) const {
    std::vector<bool> varies(swept_.size(), false);
    for (const auto& values : made.values)
      for (std::size_t i = 0; i < swept_.size(); ++i) varies[i] = varies[i] || values[i] != made.values[0][i];
    const bool single = std::find(varies.begin(), varies.end(), true) == varies.end();
    if (single && first.empty()) varies = not_derived();
    for (std::size_t c = 0; c < made.list.size(); ++c) {
      const auto parameters = named(made.values[c], varies);
      std::string label = parameters.empty() ? "" : label_of(parameters);
      if (!first.empty()) label = first + (label.empty() ? "" : "_" + label);
      if (label.empty()) label = name_of(made.list[c].definition.physics.flow);
      made.list[c].definition.label = label;
      nlohmann::ordered_json varied = nlohmann::ordered_json::object();
      for (const auto& [parameter, value] : parameters) varied[parameter] = value;
      made.list[c].varied = varied.dump();
    }
  }

  const CampaignSpec& spec_;
  const ExistingCases& existing_;
  std::vector<Point> points_;
  Derivation derivation_;
  std::vector<std::string> swept_;     ///< every parameter that a point sets or that is derived from it
  std::vector<Pointer> swept_places_;  ///< the same, to look members up by
  ExclusionUse exclusions_;
  json common_;                                 ///< the document of a case, without what the sweep sets
  json filled_;                                 ///< the same with all defaults
  std::map<Point, std::string> precursor_ids_;  ///< by what a point sets of the precursor
  Made precursors_, cases_;
  std::map<std::string, Mistake> merged_;  ///< by the pointer of the parameter
  CaseMistakes mistakes_;
};

}  // namespace

Campaign expand(const CampaignSpec& spec, const ExistingCases& existing) {
  return Expansion(spec, existing).run();
}

}  // namespace softwall::campaign
