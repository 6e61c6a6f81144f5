#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "campaign/commands/campaign_folder.hpp"

/// Cases that a change of the campaign file has left behind, with what they cost and why they are no longer
/// part of it.
namespace softwall::campaign {

struct LeftBehind {
  std::string label, case_id;
  std::string directory;  ///< relative to the campaign's folder
  std::string state;
  double core_hours = 0.0;
  std::string reason;  ///< "like G=1, but statistics.start_time 0.5 instead of 1"
};

/// The cases that lie beside those of a campaign in its folder.
struct BesideTheCampaign {
  std::vector<LeftBehind> cases;         ///< that no campaign file asks for
  std::map<std::string, int> of_others;  ///< cases that another campaign file asks for, by its name
  std::vector<std::string> unreadable;   ///< other campaign files, whose cases may be among `cases`
};

[[nodiscard]] BesideTheCampaign beside_the_campaign(const LoadedCampaign& loaded);

/// A sentence and a line for each of the first ones; nothing where none is left behind.
void print_left_behind(std::ostream& out, const LoadedCampaign& loaded, const std::vector<LeftBehind>& cases);

}  // namespace softwall::campaign
