#include "solver/case/json_schema.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "solver/case/spelling.hpp"

namespace softwall {
namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

/// Replaces {"$ref": "file#/pointer"} by what it points to.
void resolve_references(json& node, const std::map<std::string, json>& documents) {
  if (node.is_object() && node.contains("$ref")) {
    const std::string reference = node.at("$ref");
    const std::size_t hash = reference.find('#');
    const std::string file = reference.substr(0, hash);
    if (hash == std::string::npos || !documents.contains(file))
      throw std::logic_error("schema reference to an unknown document: " + reference);
    json target = documents.at(file).at(Pointer(reference.substr(hash + 1)));
    node = std::move(target);
  }
  if (node.is_structured())
    for (auto& child : node) resolve_references(child, documents);
}

const json* child_schema(const json& node, const std::string& key) {
  if (const auto properties = node.find("properties"); properties != node.end() && properties->contains(key))
    return &properties->at(key);
  if (const auto rest = node.find("additionalProperties"); rest != node.end() && rest->is_object())
    return &*rest;
  if (const auto items = node.find("items"); items != node.end() && items->is_object()) return &*items;
  return nullptr;
}

/// valijson names a place as {"<root>", "[physics]", "[grid]"}.
Pointer place(const std::vector<std::string>& context) {
  Pointer pointer;
  for (std::size_t i = 1; i < context.size(); ++i) pointer /= context[i].substr(1, context[i].size() - 2);
  return pointer;
}

/// An object or array member of the document, or null: a name such as "7" may mean either.
const json* find(const json& document, const Pointer& pointer) {
  try {
    return &document.at(pointer);
  } catch (const json::exception&) {
    return nullptr;
  }
}

std::vector<std::string> known_keys(const json& node) {
  std::vector<std::string> keys;
  if (node.contains("properties"))
    for (const auto& [key, unused] : node.at("properties").items()) keys.push_back(key);
  return keys;
}

std::string printable_pointer(const Pointer& pointer) { return printable_excerpt(pointer.to_string(), 200); }

void add_missing(const json& object, const json& node, const Pointer& at, std::vector<Mistake>& mistakes) {
  for (const std::string key : node.value("required", json::array())) {
    if (object.contains(key)) continue;
    const json* wanted = child_schema(node, key);
    mistakes.push_back({printable_pointer(at / key), kMissing, wanted ? "needs " + allowed_by(*wanted) : ""});
  }
}

/// A member that a schema describes, with what its defaults are: a schema holds many other words, and looking
/// these up in it for each case of a large campaign would take longer than all else about the case.
struct Member {
  std::string key;
  std::optional<json> standard;  ///< "default"
  std::optional<json> dropped;   ///< what stands for "as ever": "identity_default", or else "default"
  std::vector<Member> members;   ///< sorted by key, as those of a json object are
};

std::optional<json> word_in(const json& node, const char* word) {
  const auto found = node.find(word);
  return found == node.end() ? std::nullopt : std::optional<json>(*found);
}

Member member_of(const std::string& key, const json& node) {
  Member member{key, word_in(node, "default"), word_in(node, "identity_default"), {}};
  if (!member.dropped) member.dropped = member.standard;
  if (!node.contains("properties")) return member;
  for (const auto& [name, child] : node.at("properties").items())
    member.members.push_back(member_of(name, child));
  return member;
}

/// Calls `visit` with each described member and where it is in `object`, or would have to be put: both are
/// sorted, so that one pass suffices.
template <class Object, class Visit>
void walk_together(const Member& node, Object& object, const Visit& visit) {
  auto at = object.begin();
  for (const Member& child : node.members) {
    int order = 1;  // of the key that is there against the described one
    for (; at != object.end(); ++at) {
      order = at->first.compare(child.key);
      if (order >= 0) break;
    }
    visit(child, at, at != object.end() && order == 0);
  }
}

const Member* described(const Member& node, const std::string& key) {
  const auto found = std::ranges::lower_bound(node.members, key, {}, &Member::key);
  return found != node.members.end() && found->key == key ? &*found : nullptr;
}

/// Where a member of this name is described, in the object `at` of a document or below: "in /physics/solid".
std::vector<std::string> homes_of(const std::string& key, const Member& node, const std::string& at) {
  std::vector<std::string> homes;
  if (described(node, key)) homes.push_back(at.empty() ? "at the top level" : "in " + at);
  for (const Member& child : node.members)
    std::ranges::move(homes_of(key, child, at + "/" + child.key), std::back_inserter(homes));
  return homes;
}

/// An unknown key may be a known one of another object: "G" in /physics instead of /physics/solid.
void add_unknown(const json& object, const json& node, const Pointer& at, const Member& root,
                 std::vector<Mistake>& mistakes) {
  if (node.value("additionalProperties", json(true)) != json(false)) return;
  const auto known = known_keys(node);
  for (const auto& [key, unused] : object.items()) {
    if (node.at("properties").contains(key)) continue;
    Mistake mistake = unknown_key(at.to_string(), key, known);
    const auto homes = homes_of(key, root, "");
    if (homes.size() == 1) mistake.allowed = "belongs " + homes.front();
    if (homes.size() == 2) mistake.allowed = "belongs " + homes.front() + " or " + homes.back();
    mistakes.push_back(std::move(mistake));
  }
}

void fill(const Member& node, json& value) {
  if (!value.is_object() || node.members.empty()) return;
  auto& object = value.get_ref<json::object_t&>();
  walk_together(node, object, [&](const Member& child, auto& at, bool is_there) {
    if (!is_there && !child.standard) return;
    if (!is_there) at = object.emplace_hint(at, child.key, *child.standard);
    fill(child, at->second);
  });
}

json without(const Member& node, const json& value) {
  if (!value.is_object() || node.members.empty()) return value;
  const auto& object = value.get_ref<const json::object_t&>();
  json kept = json::object();
  std::size_t met = 0;
  walk_together(node, object, [&](const Member& child, auto& at, bool is_there) {
    met += is_there ? 1 : 0;
    if (!is_there && !child.standard) return;
    const json& member = is_there ? at->second : *child.standard;
    const bool is_leaf = child.members.empty();
    if (is_leaf && child.dropped && member == *child.dropped) return;  // most are, and that costs no copy
    json rest = without(child, member);
    if (!child.dropped || !(rest == *child.dropped)) kept.emplace(child.key, std::move(rest));
  });
  if (met == object.size()) return kept;
  for (const auto& [key, member] : object) {
    if (!described(node, key)) kept.emplace(key, member);
  }
  return kept;
}

bool has_deeper(const std::set<std::string>& places, const std::string& at) {
  const auto next = places.lower_bound(at + "/");
  return next != places.end() && next->starts_with(at + "/");
}

}  // namespace

struct JsonSchema::Compiled {
  valijson::Schema schema;
  Member root;
};

JsonSchema::JsonSchema(std::string_view text, const std::map<std::string, std::string_view>& others)
    : schema_(json::parse(text)) {
  std::map<std::string, json> documents{{"", schema_}};  // "#/properties/run" is a part of the schema itself
  for (const auto& [name, other] : others) documents[name] = json::parse(other);
  resolve_references(schema_, documents);

  auto compiled = std::make_shared<Compiled>();
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_), compiled->schema);
  compiled->root = member_of("", schema_);
  compiled_ = std::move(compiled);
}

std::vector<Mistake> JsonSchema::mistakes(const json& document) const {
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(compiled_->schema, valijson::adapters::NlohmannJsonAdapter(document), &results))
    return {};

  // valijson reports a mistake at its place and again at every enclosing one. Only the places are used: what
  // is wrong there is read from schema and document, because valijson's own sentences name neither.
  std::set<std::string> places;
  for (const auto& error : results) places.insert(place(error.context).to_string());
  std::vector<Mistake> found;
  for (const std::string& name : places) {
    const Pointer at(name);
    const json* value = find(document, at);
    const json* node = part(at);
    if (!value || !node) continue;
    const std::size_t before = found.size();
    if (value->is_object() && node->contains("properties")) {
      add_unknown(*value, *node, at, compiled_->root, found);
      add_missing(*value, *node, at, found);
    }
    if (found.size() == before && !has_deeper(places, name))
      found.push_back({printable_pointer(at), quoted(*value), "must be " + allowed_by(*node)});
  }
  if (found.empty()) found.push_back({"", "not valid", results.begin()->description});
  return found;
}

void JsonSchema::fill_defaults(json& document) const { fill(compiled_->root, document); }

json JsonSchema::without_defaults(const json& document) const { return without(compiled_->root, document); }

json JsonSchema::member_without_defaults(const std::string& key, const json& value) const {
  const Member* const member = described(compiled_->root, key);
  return member ? without(*member, value) : value;
}

const json* JsonSchema::part(const Pointer& pointer) const {
  if (pointer.empty()) return &schema_;
  const json* parent = part(pointer.parent_pointer());
  return parent ? child_schema(*parent, pointer.back()) : nullptr;
}

std::string quoted(const json& value) {
  if (value.is_object() || value.is_array()) {
    const std::string kind = value.is_object() ? "an object" : "an array";
    if (!value.empty()) return kind;
    return value.is_object() ? "{}" : "[]";
  }
  if (value.is_string()) return "\"" + printable_excerpt(value.get_ref<const std::string&>()) + "\"";
  return value.dump();
}

Mistake unknown_key(const std::string& pointer, const std::string& key,
                    const std::vector<std::string>& known) {
  const std::string where = printable_excerpt(pointer, 200) + "/" + printable_excerpt(key);
  if (const auto meant = suggestion(key, known))
    return {where, "unknown key", "did you mean \"" + *meant + "\"?"};
  std::string all;
  for (const auto& word : known) all += (all.empty() ? "" : ", ") + word;
  return {where, "unknown key", "known here: " + all};
}

}  // namespace softwall
