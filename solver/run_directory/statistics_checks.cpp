#include <algorithm>
#include <cmath>
#include <functional>

#include "solver/run_directory/quantities.hpp"
#include "solver/run_directory/statistics_checks.hpp"

namespace softwall::analysis {
namespace {

constexpr double kRoundOff = 1e-12;

bool strictly_increasing(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return !(a < b); }) ==
             values.end() &&
         std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

void check_grid(const BlockStatistics& s, std::vector<std::string>& found) {
  if (!(s.reynolds > 0.0) || !std::isfinite(s.reynolds)) found.emplace_back("reynolds is not positive");
  if (s.y_center.empty() || s.y_face.size() != s.y_center.size() + 1) {
    found.emplace_back("y_face must hold one value more than y_center, which holds " +
                       std::to_string(s.y_center.size()));
    return;
  }
  if (!strictly_increasing(s.y_center) || !strictly_increasing(s.y_face)) {
    found.emplace_back("y_center and y_face must increase strictly");
  }
  if (s.y_face.front() != 0.0) found.emplace_back("y_face must begin at 0");
  // A stretched grid places its last fluid face at 2 up to round-off.
  const double top = s.y_face.back();
  if (!(s.interface_y > s.y_center.front()) || s.interface_y > top * (1.0 + kRoundOff)) {
    found.emplace_back("interface_y lies outside the channel");
  } else if (!s.elastic && s.interface_y < top * (1.0 - kRoundOff)) {
    found.emplace_back("interface_y of a rigid channel must be its upper wall");
  }
}

void check_blocks(const BlockStatistics& s, std::vector<std::string>& found) {
  if (s.end.size() != s.blocks() || s.weight.size() != s.blocks()) {
    found.emplace_back("start, end and weight differ in length");
    return;
  }
  for (std::size_t b = 0; b < s.blocks(); ++b) {
    if (!(s.start[b] < s.end[b]) || !(s.weight[b] >= 0.0) || !std::isfinite(s.weight[b])) {
      found.emplace_back("block " + std::to_string(b) + " must end after it starts and have a weight >= 0");
    }
    if (b > 0 && !(s.start[b - 1] < s.start[b])) {
      found.emplace_back("block " + std::to_string(b) + " does not start after the block before it");
    }
  }
}

}  // namespace

std::vector<std::string> mistakes(const BlockStatistics& s) {
  std::vector<std::string> found;
  check_grid(s, found);
  check_blocks(s, found);
  const auto check_name = [&](const std::string& name) {
    if (name.empty() || name.find('/') != std::string::npos) {
      found.emplace_back("\"" + name + "\" is not a usable name");
    } else if (meaning_of(s, name) == nullptr) {
      found.emplace_back(name + " has no unit and description: give them in meanings");
    }
  };
  for (const auto& [name, profile] : s.profiles) {
    check_name(name);
    if (profile.values.size() != s.blocks() * s.points(profile.location)) {
      found.emplace_back("profile " + name + " does not hold one value for each block and point");
    }
  }
  for (const auto& [name, values] : s.series) {
    check_name(name);
    if (values.size() != s.blocks()) {
      found.emplace_back("series " + name + " does not hold one value for each block");
    }
  }
  return found;
}

}  // namespace softwall::analysis
