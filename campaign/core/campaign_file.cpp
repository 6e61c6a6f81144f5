#include "campaign/core/campaign_file.hpp"

#include <utility>

#include "campaign/core/expand.hpp"
#include "campaign/core/spec.hpp"
#include "solver/case/input_file.hpp"

namespace softwall::campaign {
namespace {

/// The mistakes that only the cases show, so that a user learns of them together with the others.
void add_case_mistakes(const CampaignSpec& spec, std::vector<Mistake>& mistakes) {
  try {
    static_cast<void>(expand(spec));
  } catch (const BadInput& more) {
    mistakes.insert(mistakes.end(), more.mistakes.begin(), more.mistakes.end());
  }
}

}  // namespace

Campaign parse_campaign(const std::string& text, const std::string& source, const ExistingCases& existing) {
  CheckedSpec checked = check_spec(text, source);
  if (checked.mistakes.empty()) return expand(checked.spec, existing);
  if (checked.can_expand) add_case_mistakes(checked.spec, checked.mistakes);
  throw BadInput(source, std::move(checked.mistakes));
}

Campaign read_campaign(const std::filesystem::path& file, const ExistingCases& existing) {
  return parse_campaign(read_input_file(file), file.string(), existing);
}

}  // namespace softwall::campaign
