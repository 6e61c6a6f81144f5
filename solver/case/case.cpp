#include "solver/case/case.hpp"

#include <nlohmann/json.hpp>

#include "schemas/embedded.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/case_checks.hpp"
#include "solver/case/case_json.hpp"
#include "solver/case/case_schema.hpp"
#include "solver/case/input_file.hpp"
#include "solver/case/json_text.hpp"

namespace softwall {

using nlohmann::json;

const JsonSchema& case_schema() {
  static const JsonSchema schema(schemas::kCaseSchema);
  return schema;
}

std::vector<Mistake> case_mistakes(const json& document, const json& filled) {
  std::vector<Mistake> mistakes = case_schema().mistakes(document);
  for (auto& more : case_cross_checks(filled, mistakes)) mistakes.push_back(std::move(more));
  return mistakes;
}

Case case_from_json(json document, const std::string& source) {
  document = normalised(std::move(document));
  json filled = document;
  case_schema().fill_defaults(filled);
  if (auto mistakes = case_mistakes(document, filled); !mistakes.empty())
    throw BadInput(source, std::move(mistakes));
  return valid_case(filled);
}

Case parse_case(const std::string& text) { return case_from_json(parse_json(text, "case"), "case"); }

Case read_case(const std::filesystem::path& case_file) {
  const std::string source = case_file.string();
  return case_from_json(parse_json(read_input_file(case_file), source), source);
}

}  // namespace softwall
