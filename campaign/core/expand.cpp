#include "campaign/core/expand.hpp"

#include <map>
#include <set>

#include "campaign/core/case_mistakes.hpp"
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

json document_of(const json& physics, const json& run) {
  return {{"format", 1}, {"label", ""}, {"physics", physics}, {"run", run}};
}

json with_defaults(json document) {
  case_schema().fill_defaults(document);
  return document;
}

/// The rigid channel before a wall is made elastic shares its fluid with the elastic case, not its numerics.
bool concerns_precursor(const std::string& pointer) {
  return pointer == "/reynolds" || pointer == "/domain/length_x" || pointer == "/domain/length_z" ||
         (pointer.starts_with("/grid/") && pointer != "/grid/ny_solid");
}

void put(const Point& point, json& physics) {
  for (const auto& [pointer, value] : point) physics[Pointer(pointer)] = value;
}

class Expansion {
 public:
  explicit Expansion(const CampaignSpec& spec)
      : spec_(spec), points_(sweep_points(spec.sweep)), swept_(swept_pointers(points_)) {}

  Campaign run() {
    for (const auto& point : points_) add(point);
    mistakes_.throw_if_any(spec_.source, points_.size());
    Campaign campaign{spec_.name, spec_.description, std::move(precursors_), spec_.execution, spec_.text};
    for (auto& c : cases_) campaign.cases.push_back(std::move(c));
    if (campaign.cases.empty())
      throw BadInput(spec_.source, {{"/sweep/exclude", "excludes every case", "leave some"}});
    return campaign;
  }

 private:
  void add(const Point& point) {
    json physics = spec_.physics;
    put(point, physics);
    if (!physics.contains("flow"))
      physics["flow"] = campaign_schema().part(Pointer("/physics/flow"))->at("default");
    json document = document_of(physics, spec_.run);
    if (is_excluded(spec_.sweep.at("exclude"), with_defaults(document).at("physics"))) return;
    std::string precursor_id;
    if (!spec_.precursor.is_null()) {
      precursor_id = add_precursor(point);
      document["physics"]["initial"] = {{"type", "precursor"},
                                        {"precursor", precursor_id},
                                        {"precursor_time", spec_.precursor.at("run").at("end_time")}};
    }
    document["label"] = label(document, swept_);
    add_case(std::move(document), "", precursor_id, cases_);
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
    json document = document_of(physics, run);
    document["label"] = precursor_label(document);
    return add_case(std::move(document), "/precursor: ", "", precursors_);
  }

  /// Checks a case and appends it unless it is there already. Returns its id.
  std::string add_case(json document, const std::string& prefix, const std::string& precursor_id,
                       std::vector<CampaignCase>& to) {
    const std::string label = document.at("label");
    const bool is_precursor = &to == &precursors_;
    if (auto found = case_mistakes(document); !found.empty()) {
      mistakes_.add(label, prefix, std::move(found));
      return std::string(16, '0');  // lets the cases that start from it be checked all the same
    }
    CampaignCase made;
    made.definition = valid_case(with_defaults(std::move(document)));
    made.directory = case_directory(label, made.definition.id);
    made.is_precursor = is_precursor;
    made.precursor_id = precursor_id;
    made.ranks = is_precursor ? spec_.execution.precursor_ranks : spec_.execution.ranks;
    const std::string id = made.definition.id;
    if (ids_.insert(id).second) to.push_back(std::move(made));
    return id;
  }

  [[nodiscard]] std::string precursor_label(const json& document) const {
    std::vector<std::string> concerned;
    for (const auto& pointer : swept_)
      if (concerns_precursor(pointer)) concerned.push_back(pointer);
    return concerned.empty() ? "precursor" : safe_label("precursor_" + label(document, concerned));
  }

  /// The values of these parameters in the case, whether this point sets them or a default does.
  [[nodiscard]] static std::string label(const json& document, const std::vector<std::string>& pointers) {
    const json physics = with_defaults(document).at("physics");
    if (pointers.empty()) return physics.at("flow");
    std::vector<std::pair<std::string, json>> values;
    for (const auto& pointer : pointers)
      if (physics.contains(Pointer(pointer)))
        values.emplace_back(Pointer(pointer).back(), physics.at(Pointer(pointer)));
    return label_of(values);
  }

  const CampaignSpec& spec_;
  std::vector<Point> points_;
  std::vector<std::string> swept_;
  std::vector<CampaignCase> precursors_, cases_;
  std::set<std::string> ids_;
  CaseMistakes mistakes_;
};

}  // namespace

Campaign expand(const CampaignSpec& spec) { return Expansion(spec).run(); }

}  // namespace softwall::campaign
