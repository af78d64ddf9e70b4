#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/correspondence/bearings/visibility_grid.h"
#include "mrpt_ext/correspondence/scan_bearing.h"

namespace mrpt_ext
{
/// Effort of one round of triples.
struct TripleEffort
{
  double tested = 0, possible = 0;  ///< landmark triples tried, and those that give a pose
  double in_view = 0;               ///< landmarks in view of a pose
};

/// The grid to vote on if that is expected to cost less than rounds of triples, or nothing. `misses`: bearings that
/// may be outliers. `built`: layout of an existing grid, preferred to one that has to be built.
[[nodiscard]] std::optional<VisibilityGrid::Layout> chooseVisibilityGrid(
    const LandmarkIndex& map, const Box2& area, double max_range, std::span<const ScanBearing> bearings, double gate,
    const TripleEffort& triples, int misses, const VisibilityGrid::Layout* built);
}  // namespace mrpt_ext
