#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/correspondence/bearings/visibility_grid.h"
#include "mrpt_ext/correspondence/scan_bearing.h"

namespace mrpt_ext
{
/// What one round of triples amounts to.
struct TripleEffort
{
  double tested = 0, possible = 0;  ///< constellations of landmarks tried, and those that give a pose
  double in_view = 0;               ///< landmarks in view of a pose
};

/// The grid to count off when that is expected to cost less than rounds of triples, or nothing. `misses`: readings that
/// may be without landmark. `built`: a grid whose panoramas exist, preferred to one that would have to be built.
[[nodiscard]] std::optional<PanoramaIndex::Plan> choosePanoramas(const LandmarkIndex& map, const Box2& area,
                                                                 double max_range,
                                                                 std::span<const ScanBearing> readings, double gate,
                                                                 const TripleEffort& triples, int misses,
                                                                 const PanoramaIndex::Plan* built);
}  // namespace mrpt_ext
