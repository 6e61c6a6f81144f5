#include "campaign/core/expand.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <unordered_set>

#include "campaign/core/case_mistakes.hpp"
#include "campaign/core/derive.hpp"
#include "campaign/core/effect.hpp"
#include "campaign/core/label.hpp"
#include "campaign/core/made_cases.hpp"
#include "campaign/core/precursor.hpp"
#include "campaign/core/sound_values.hpp"
#include "campaign/core/start_order.hpp"
#include "campaign/core/swept_parameters.hpp"
#include "solver/case/case_checks.hpp"
#include "solver/case/case_json.hpp"
#include "solver/case/case_schema.hpp"
#include "solver/case/json_schema.hpp"

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

constexpr const char* kDtPlus = "/solid/dt_plus";
constexpr const char* kFixedDt = "/time_step/fixed_dt";

/// Gives an elastic wall the campaign's default of solid.dt_plus, which is not that of a case.
void limit_steps(json& physics) {
  physics[Pointer(kDtPlus)] = campaign_schema().part(Pointer("/physics/solid/dt_plus"))->at("default");
}

void note_who_starts_others(std::vector<CampaignCase>& cases) {
  std::unordered_set<std::string> starting;
  for (const CampaignCase& one : cases) starting.insert(one.precursor_id);
  for (CampaignCase& one : cases) one.starts_others = starting.contains(one.definition.id);
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
    spec_.start_from ? add_in_lines(*spec_.start_from) : add_one_by_one();
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
                      .start_from = spec_.start_from,
                      .execution = spec_.execution,
                      .spec_text = spec_.text};
    std::ranges::move(cases_.take(), std::back_inserter(campaign.cases));
    note_who_starts_others(campaign.cases);
    make_labels_distinct(campaign);
    return campaign;
  }

 private:
  /// A case before it has been checked.
  struct Candidate {
    json filled;               ///< the document with all defaults
    std::vector<json> values;  ///< by swept pointer, before it was told where to start from
    Point point;               ///< what the sweep sets and what is derived from it
    bool any_steps = false;    ///< the campaign does not say how long its steps may be
    json initial;              ///< the case that it starts from; null: it starts by itself
    json written;              ///< the document without defaults; null: it follows from the others
  };

  /// The state that a case begins with: the end of another.
  struct End {
    std::string case_id;
    json time;
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
    if (spec_.start_from && !has_neighbours_)
      found.push_back({"/start_from/nearest", quoted(json(Pointer(spec_.start_from->nearest).back())),
                       "has no effect: no two cases differ in it alone"});
    if (!found.empty()) throw BadInput(spec_.source, std::move(found));
  }

  void add_one_by_one() {
    for (const Point& point : points_) {
      auto candidate = prepare(point);
      if (!candidate) continue;
      start_by_precursor(*candidate);
      add_case(std::move(*candidate), cases_, sound_);
    }
  }

  /// Each case after the one that it starts from, whose id is a part of its own.
  void add_in_lines(const StartFrom& start_from) {
    std::vector<Candidate> candidates;
    std::vector<LinePlace> places;
    for (const Point& point : points_) {
      auto candidate = prepare(point);
      if (!candidate) continue;
      places.push_back(place_of(*candidate, start_from.nearest));
      candidates.push_back(std::move(*candidate));
    }
    std::vector<std::string> ids(candidates.size());
    std::vector<json> physics(candidates.size());
    for (const auto& [i, neighbour] : start_order(places, start_from.from_largest)) {
      physics[i] = candidates[i].filled.at("physics");
      if (neighbour) {
        auto found = neighbour_mistakes(physics[i], physics[*neighbour]);
        mistakes_.add(swept_.label(candidates[i].values), "", std::move(found));
        has_neighbours_ = true;
        start_from_case(candidates[i], "neighbour", {ids[*neighbour], spec_.run.at("end_time")});
      } else {
        start_by_precursor(candidates[i]);
      }
      ids[i] = add_case(std::move(candidates[i]), cases_, sound_);
    }
  }

  [[nodiscard]] LinePlace place_of(const Candidate& candidate, const std::string& nearest) const {
    std::string line;
    for (std::size_t i = 0; i < swept_.size(); ++i)
      if (swept_.pointer(i) != nearest && !swept_.is_derived(i)) line += candidate.values[i].dump() + "\n";
    const json& physics = candidate.filled.at("physics");
    const Pointer place(nearest);
    if (!physics.contains(place) || !physics.at(place).is_number()) return {line, std::nullopt};
    return {line, physics.at(place).get<double>()};
  }

  /// The case of a point, before it is told where to start from; none where the point is excluded or cannot
  /// be derived. The defaults of what all cases have in common are filled in once. They are filled in again
  /// after the point's values have been put, because a point may bring in an object that has further members.
  std::optional<Candidate> prepare(Point point) {
    if (!derivation_.empty() && !derive(point)) return std::nullopt;
    Candidate candidate;
    json& filled = candidate.filled = filled_;
    put(point, filled.at("physics"));
    candidate.any_steps = leaves_steps_open(point, filled.at("physics"));
    if (candidate.any_steps) limit_steps(filled.at("physics"));
    case_schema().fill_defaults(filled);
    if (exclusions_.excludes(filled.at("physics"))) return std::nullopt;
    derivation_.note_effect(filled.at("physics"));
    candidate.values = swept_.values_of(filled.at("physics"));
    candidate.point = std::move(point);
    return candidate;
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

  static void start_from_case(Candidate& candidate, const char* type, const End& end) {
    candidate.initial = {{"type", type}, {"precursor", end.case_id}, {"precursor_time", end.time}};
    candidate.filled.at("physics")["initial"] = candidate.initial;
    case_schema().fill_defaults(candidate.filled);
  }

  void start_by_precursor(Candidate& candidate) {
    if (spec_.precursor.is_null()) return;
    start_from_case(candidate, "precursor",
                    {precursor_for(candidate.point), spec_.precursor.at("run").at("end_time")});
  }

  /// Id of the precursor that this point's case starts from; made if no earlier point needed the same.
  std::string precursor_for(const Point& point) {
    const Point shared = shared_with_precursor(point);
    const auto [known, is_new] = precursor_ids_.try_emplace(shared);
    if (is_new) known->second = add_precursor(shared);
    return known->second;
  }

  std::string add_precursor(const Point& shared) {
    Candidate candidate;
    candidate.written = precursor_document(common_, spec_.precursor, shared);
    candidate.filled = with_defaults(candidate.written);
    candidate.values = swept_.values_of(candidate.filled.at("physics"));
    candidate.point = shared;
    return add_case(std::move(candidate), precursors_, sound_precursors_);
  }

  /// The document of a case without defaults, which messages speak of.
  [[nodiscard]] json written(const Candidate& candidate) const {
    if (!candidate.written.is_null()) return candidate.written;
    json document = common_;
    put(candidate.point, document.at("physics"));
    if (candidate.any_steps) limit_steps(document.at("physics"));
    if (!candidate.initial.is_null()) document.at("physics")["initial"] = candidate.initial;
    return document;
  }

  /// The mistakes of what was written. Defaults have none, nor does the schema require what has a default, so
  /// that the filled document of a sound case tells that it is one.
  [[nodiscard]] std::vector<Mistake> mistakes_of(const Candidate& candidate, SoundValues& sound) const {
    auto found = sound.covers(candidate.point) ? case_cross_checks(candidate.filled, {})
                                               : case_mistakes(candidate.filled, candidate.filled);
    if (!found.empty()) return case_mistakes(written(candidate), candidate.filled);
    sound.note_sound(candidate.point);
    return found;
  }

  /// Checks a case and appends it unless it is there already. Returns its id.
  std::string add_case(Candidate candidate, MadeCases& to, SoundValues& sound) {
    json& document = candidate.filled;
    const bool is_precursor = &to == &precursors_;
    const auto refuse = [&](std::vector<Mistake> found) {
      mistakes_.add(swept_.label(candidate.values), is_precursor ? "/precursor: " : "", std::move(found));
      return std::string(16, '0');  // lets the cases that start from it be checked all the same
    };
    if (auto found = mistakes_of(candidate, sound); !found.empty()) return refuse(std::move(found));
    CampaignCase made;
    made.window_start = document.at("physics").at("statistics").at("start_time");
    continue_existing(document.at("physics"), candidate.any_steps);
    if (auto never = never_sampled(document, made.window_start)) return refuse({*never});
    made.definition = valid_case(document);
    made.is_precursor = is_precursor;
    made.precursor_id = candidate.initial.is_null() ? "" : candidate.initial.at("precursor");
    if (!is_precursor) made.until = spec_.until;  // the end of a precursor is a part of what starts from it
    made.ranks = is_precursor ? spec_.execution.precursor_ranks : spec_.execution.ranks;
    if (!is_precursor) to.note_idle(document.at("physics"), candidate.values);
    std::string id = made.definition.id;
    to.add(std::move(made), std::move(candidate.values));
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
  bool has_neighbours_ = false;  ///< some case starts from another of the sweep
};

}  // namespace

Campaign expand(const CampaignSpec& spec, const ExistingCases& existing) {
  return Expansion(spec, existing).run();
}

}  // namespace softwall::campaign
