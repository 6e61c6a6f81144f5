#include "campaign/core/expand.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

#include "campaign/core/case_mistakes.hpp"
#include "campaign/core/derive.hpp"
#include "campaign/core/effect.hpp"
#include "campaign/core/label.hpp"
#include "campaign/core/made_cases.hpp"
#include "campaign/core/sound_values.hpp"
#include "campaign/core/swept_parameters.hpp"
#include "solver/case/case_checks.hpp"
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

class Expansion {
 public:
  Expansion(const CampaignSpec& spec, const ExistingCases& existing)
      : spec_(spec),
        existing_(existing),
        points_(sweep_points(spec.sweep)),
        derivation_(spec.derive),
        swept_(points_, derivation_),
        exclusions_(spec.sweep.at("exclude")),
        common_(document_of(physics_with_flow(spec.physics), spec.run)),
        filled_(with_defaults(common_)),
        precursors_(swept_),
        cases_(swept_) {}

  Campaign run() {
    cases_.reserve(points_.size());
    for (const auto& point : points_) add(point);
    mistakes_.throw_if_any(spec_.source, points_.size());
    if (cases_.empty())
      throw BadInput(spec_.source, {{"/sweep/exclude", "excludes every case", "leave some"}});
    refuse_what_has_no_effect();
    precursors_.name("precursor");
    cases_.name("");
    Campaign campaign{.name = spec_.name,
                      .description = spec_.description,
                      .cases = precursors_.take(),
                      .until = spec_.until,
                      .execution = spec_.execution,
                      .spec_text = spec_.text};
    std::ranges::move(cases_.take(), std::back_inserter(campaign.cases));
    make_labels_distinct(campaign);
    return campaign;
  }

 private:
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

  void refuse_what_has_no_effect() const {
    auto found = exclusions_.unused();
    for (auto& mistake : derivation_.without_effect()) found.push_back(std::move(mistake));
    for (const auto& [pointer, mistake] : cases_.merged()) found.push_back(mistake);
    if (!found.empty()) throw BadInput(spec_.source, std::move(found));
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
    std::vector<json> values = swept_.values_of(filled.at("physics"));
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
             cases_, sound_);
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
    if (!exclusions_.excludes(physics))
      mistakes_.add(swept_.label(swept_.values_of(physics)), "", std::move(found));
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
    std::vector<json> values = swept_.values_of(filled.at("physics"));
    return add_case({.filled = std::move(filled),
                     .values = std::move(values),
                     .written = [&] { return document; },
                     .precursor_id = "",
                     .point = fluid},
                    precursors_, sound_precursors_);
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
  std::string add_case(Candidate candidate, MadeCases& to, SoundValues& sound) {
    auto& [document, values, written, precursor_id, point, any_steps] = candidate;
    const bool is_precursor = &to == &precursors_;
    const auto refuse = [&, &swept = values](std::vector<Mistake> found) {
      mistakes_.add(swept_.label(swept), is_precursor ? "/precursor: " : "", std::move(found));
      return std::string(16, '0');  // lets the cases that start from it be checked all the same
    };
    if (auto found = mistakes_of(candidate, sound); !found.empty()) return refuse(std::move(found));
    CampaignCase made;
    made.window_start = document.at("physics").at("statistics").at("start_time");
    continue_existing(document.at("physics"), any_steps);
    if (auto never = never_sampled(document, made.window_start)) return refuse({*never});
    made.definition = valid_case(document);
    made.is_precursor = is_precursor;
    made.precursor_id = precursor_id;
    if (!is_precursor) made.until = spec_.until;  // the end of a precursor is a part of what starts from it
    made.ranks = is_precursor ? spec_.execution.precursor_ranks : spec_.execution.ranks;
    if (!is_precursor) to.note_idle(document.at("physics"), values);
    std::string id = made.definition.id;
    to.add(std::move(made), std::move(values));
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

  const CampaignSpec& spec_;
  const ExistingCases& existing_;
  std::vector<Point> points_;
  Derivation derivation_;
  SweptParameters swept_;
  ExclusionUse exclusions_;
  json common_;                                 ///< the document of a case, without what the sweep sets
  json filled_;                                 ///< the same with all defaults
  std::map<Point, std::string> precursor_ids_;  ///< by what a point sets of the precursor
  MadeCases precursors_, cases_;
  SoundValues sound_precursors_, sound_;
  CaseMistakes mistakes_;
};

}  // namespace

Campaign expand(const CampaignSpec& spec, const ExistingCases& existing) {
  return Expansion(spec, existing).run();
}

}  // namespace softwall::campaign
