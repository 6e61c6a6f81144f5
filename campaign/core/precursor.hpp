#pragma once

#include <nlohmann/json.hpp>

#include "campaign/core/sweep.hpp"

/// The rigid channel whose end starts cases with an elastic wall.
namespace softwall::campaign {

/// What a point sets of its precursor, which has the fluid and the start of the elastic case, not its
/// numerics.
[[nodiscard]] Point shared_with_precursor(Point point);

/// The document of a precursor, without defaults. common: that of every case, without what the sweep sets;
/// own: what a precursor has otherwise; shared: what a point sets of it. Of the planes of a film it has those
/// in the channel.
[[nodiscard]] nlohmann::json precursor_document(nlohmann::json common, const nlohmann::json& own,
                                                const Point& shared);

}  // namespace softwall::campaign
