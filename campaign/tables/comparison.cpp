#include "campaign/tables/comparison.hpp"

#include <algorithm>
#include <cmath>

namespace softwall::campaign {
namespace {

constexpr double kPaperReynolds = 2800.0;
constexpr double kPaperLayerHeight = 0.5;  ///< [h]
constexpr double kSameParameter = 1e-9;    ///< relative; a sweep may compute its points

bool is_same(std::optional<double> a, std::optional<double> b) {
  if (!a || !b) return !a && !b;
  return std::abs(*a - *b) <= kSameParameter * std::abs(*b);
}

bool is_comparable(const MeasuredCase& measured) {
  const bool is_channel = measured.flow == "rigid_channel" || measured.flow == "elastic_wall";
  return is_channel && is_same(measured.reynolds, kPaperReynolds) &&
         (!measured.g || is_same(measured.layer_height, kPaperLayerHeight));
}

}  // namespace

bool is_match(const MeasuredCase& measured, const PaperCase& paper, const Reading& reading) {
  return is_comparable(measured) && is_same(measured.g, reading.modulus(paper)) &&
         is_same(measured.viscosity_ratio, paper.viscosity_ratio);
}

bool has_counterpart(const MeasuredCase& measured) {
  return std::ranges::any_of(paper_cases(), [&](const PaperCase& paper) {
    return std::ranges::any_of(kReadings,
                               [&](const Reading& reading) { return is_match(measured, paper, reading); });
  });
}

}  // namespace softwall::campaign
