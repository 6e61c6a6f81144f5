#include "campaign/core/derive.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "campaign/core/effect.hpp"
#include "campaign/core/round_off.hpp"
#include "solver/case/case_id.hpp"
#include "solver/case/case_schema.hpp"
#include "solver/case/json_text.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

std::string place_of(const std::string& name) { return "/derive/" + printable_excerpt(name); }

/// The names that each derived parameter needs, all by pointer; only of expressions that can be read.
using Needs = std::map<std::string, std::set<std::string>>;

/// Appends to `order` what this one needs and then itself. What needs itself on the way is the circle that is
/// returned: the first of `path` is met again.
std::vector<std::string> visit(const std::string& pointer, const Needs& needs, std::vector<std::string>& path,
                               std::vector<std::string>& order) {
  if (std::ranges::find(order, pointer) != order.end()) return {};
  if (const auto begin = std::ranges::find(path, pointer); begin != path.end()) return {begin, path.end()};
  path.push_back(pointer);
  for (const std::string& needed : needs.at(pointer)) {
    if (!needs.contains(needed)) continue;
    if (auto circle = visit(needed, needs, path, order); !circle.empty()) return circle;
  }
  path.pop_back();
  order.push_back(pointer);
  return {};
}

/// What an expression says about itself, before its value is known.
std::vector<Mistake> mistakes_in(const std::string& name, const std::string& text,
                                 std::set<std::string>& needed) {
  std::vector<Mistake> mistakes;
  try {
    const Expression expression(text);
    for (const std::string& operand : expression.names()) {
      if (const Parameter* parameter = find_parameter(operand)) {
        needed.insert(parameter->pointer.to_string());
        continue;
      }
      Mistake mistake = unknown_key("/derive", operand, parameter_names());
      mistakes.push_back(
          {place_of(name), "no such parameter: " + printable_excerpt(operand), mistake.allowed});
    }
  } catch (const ExpressionError& error) {
    mistakes.push_back({place_of(name), quoted(json(text)), error.what()});
  }
  return mistakes;
}

/// The place in the file where the sweep sets this parameter; empty: nowhere.
std::string place_in_sweep(const json& sweep, const Parameter* parameter) {
  const auto names_it = [&](const json& named) {
    return std::ranges::any_of(named.items(),
                               [&](const auto& item) { return find_parameter(item.key()) == parameter; });
  };
  for (const char* part : {"grid", "zip"})
    if (names_it(sweep.at(part))) return std::string("/sweep/") + part;
  for (const json& values : sweep.at("list"))
    if (names_it(values)) return "/sweep/list";
  return "";
}

std::string dotted(const std::vector<std::string>& circle) {
  std::string text;
  for (const std::string& pointer : circle) text += json::json_pointer(pointer).back() + " needs ";
  return text + json::json_pointer(circle.front()).back();
}

}  // namespace

std::vector<Mistake> derive_mistakes(const json& derive, const json& sweep, const json& physics) {
  std::vector<Mistake> mistakes;
  Needs needs;
  std::map<std::string, std::string> names;
  for (const auto& [name, text] : derive.items()) {
    std::set<std::string> needed;
    for (Mistake& mistake : mistakes_in(name, text, needed)) mistakes.push_back(std::move(mistake));
    const Parameter* parameter = find_parameter(name);
    if (!parameter) {
      mistakes.push_back(
          {place_of(name), "no such parameter", unknown_key("/derive", name, parameter_names()).allowed});
      continue;
    }
    if (!needs.emplace(parameter->pointer.to_string(), needed).second)
      mistakes.push_back({place_of(name), "the same parameter under two names", "name it once"});
    names[parameter->pointer.to_string()] = name;
    if (const std::string place = place_in_sweep(sweep, parameter); !place.empty())
      mistakes.push_back({place_of(name), "is swept as well", "derive it, or leave it in " + place});
    if (physics.contains(parameter->pointer))
      mistakes.push_back({place_of(name), "is fixed as well",
                          "derive it, or leave it in /physics" + parameter->pointer.to_string()});
  }
  std::vector<std::string> order, path;
  for (const auto& [pointer, needed] : needs) {
    const auto circle = visit(pointer, needs, path, order);
    if (circle.empty()) continue;
    mistakes.push_back({place_of(names.at(circle.front())), "needs itself", dotted(circle)});
    break;  // what hangs on a circle cannot be told from another one
  }
  return mistakes;
}

Derivation::Derivation(const json& derive) {
  Needs needs;
  std::map<std::string, std::pair<std::string, std::string>> written;  // name and text, by pointer
  for (const auto& [name, text] : derive.items()) {
    const std::string pointer = find_parameter(name)->pointer.to_string();
    written[pointer] = {name, text};
    const Expression expression(text.get_ref<const std::string&>());
    for (const std::string& operand : expression.names())
      needs[pointer].insert(find_parameter(operand)->pointer.to_string());
    needs[pointer];  // also where it needs none
  }
  std::vector<std::string> order, path;
  for (const auto& [pointer, needed] : needs) visit(pointer, needs, path, order);
  for (const std::string& pointer : order) {
    const auto& [name, text] = written.at(pointer);
    const json* schema = case_schema().part(json::json_pointer("/physics" + pointer));
    rules_.push_back({name, text, find_parameter(name), Expression(text), JsonSchema(schema->dump())});
  }
}

std::vector<std::string> Derivation::pointers() const {
  std::vector<std::string> all;
  for (const Rule& rule : rules_) all.push_back(rule.parameter->pointer.to_string());
  return all;
}

std::vector<Mistake> Derivation::add_to(Point& point, json physics) const {
  const auto value_of = [&](const std::string& name) {
    const auto& pointer = find_parameter(name)->pointer;
    if (!physics.contains(pointer)) throw ExpressionError("needs " + name + ", which this case has not");
    const json& value = physics.at(pointer);
    if (!value.is_number())
      throw ExpressionError("needs " + name + ", which is no number but " + quoted(value));
    return value.get<double>();
  };
  Point derived;
  for (const Rule& rule : rules_) {
    try {
      const json value = normalised_number(without_round_off(rule.expression.value(value_of)));
      for (const Mistake& mistake : rule.allowed.mistakes(value))
        return {{place_of(rule.name), quoted(value) + " from " + quoted(json(rule.text)), mistake.allowed}};
      physics[rule.parameter->pointer] = value;
      derived[rule.parameter->pointer.to_string()] = value;
    } catch (const ExpressionError& error) {
      return {{place_of(rule.name), quoted(json(rule.text)), error.what()}};
    }
  }
  point.merge(derived);
  return {};
}

/// A case depends on a value when another one would give it another id, and another result.
void Derivation::note_effect(const json& physics) {
  const auto idle = members_without_effect(physics);
  std::optional<std::string> id;
  for (Rule& rule : rules_) {
    if (rule.has_effect || std::ranges::find(idle, rule.parameter->pointer.to_string()) != idle.end())
      continue;
    if (!id) id = case_id(physics);
    json other = physics;
    json& value = other[rule.parameter->pointer];
    value = value == 0 ? 1.0 : value.get<double>() / 2;
    rule.has_effect = case_id(other) != *id;
  }
}

std::vector<Mistake> Derivation::without_effect() const {
  std::vector<Mistake> mistakes;
  for (const Rule& rule : rules_) {
    if (!rule.has_effect)
      mistakes.push_back({place_of(rule.name), quoted(json(rule.text)),
                          "has no effect: no case has such a value, leave it out"});
  }
  return mistakes;
}

std::vector<std::string> set_pointers(const std::vector<Point>& points, const Derivation& derivation) {
  auto pointers = swept_pointers(points);
  for (const auto& pointer : derivation.pointers()) pointers.push_back(pointer);
  std::ranges::sort(pointers);
  return pointers;
}

}  // namespace softwall::campaign
