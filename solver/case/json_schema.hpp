#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/bad_input.hpp"

namespace softwall {

/// One of our schemas: says what is wrong with a document and fills in what it leaves out.
/// valijson decides whether a document is valid; this class only says it in words a user can act on.
class JsonSchema {
 public:
  /// `text` is a draft-07 schema. A reference {"$ref": "case.schema.json#/properties/run"} is replaced by
  /// that part of the document of that name in `others`, so that a parameter is described once only.
  explicit JsonSchema(std::string_view text, const std::map<std::string, std::string_view>& others = {});

  /// Every mistake in the document, sorted by place; empty when it is valid.
  [[nodiscard]] std::vector<Mistake> mistakes(const nlohmann::json& document) const;

  /// Writes the "default" of every absent member into the document, also inside objects that themselves have
  /// a default. Members of the wrong type are left as they are.
  void fill_defaults(nlohmann::json& document) const;

  /// The opposite: a document without the members that equal their default, whether written or left out, also
  /// where objects thereby become empty. A node whose default has changed names the first one as
  /// "identity_default"; that is what is dropped.
  [[nodiscard]] nlohmann::json without_defaults(const nlohmann::json& document) const;
  /// The same of what stands under this key of a document.
  [[nodiscard]] nlohmann::json member_without_defaults(const std::string& key,
                                                       const nlohmann::json& value) const;

  /// The schema of one part, by the pointer it would have in a document: "/physics/grid"; null when there is
  /// none.
  [[nodiscard]] const nlohmann::json* part(const nlohmann::json::json_pointer& pointer) const;

 private:
  struct Compiled;  ///< valijson's form; its headers stay out of ours
  nlohmann::json schema_;
  std::shared_ptr<const Compiled> compiled_;
};

/// What is "given" in the mistake of a member that is not there although the schema requires it.
inline constexpr const char* kMissing = "missing";

/// "an integer from 4 to 100000", "one of \"js\", \"z\"": what a schema node allows.
[[nodiscard]] std::string allowed_by(const nlohmann::json& schema_node);

/// A value as it is quoted in a message: JSON, cut to a readable length.
[[nodiscard]] std::string quoted(const nlohmann::json& value);

/// "unknown key", with the key that was probably meant or else all that are known.
[[nodiscard]] Mistake unknown_key(const std::string& pointer, const std::string& key,
                                  const std::vector<std::string>& known);

}  // namespace softwall
