#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/local_map/past_scan.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// What each reading saw without being able to name it, with what the way since has added kept apart; oldest first.
[[nodiscard]] std::vector<PastScan> carriedPlaces(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                                  const LandmarkIndex& index);

/// The unidentified detections of joined readings as one constellation for a search (local_map.h): in place
/// of scansOf wherever the readings are of several moments. Readings of one moment come out as scansOf has
/// them.
[[nodiscard]] std::vector<Scan> windowScans(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                            const LandmarkIndex& index);
}  // namespace mrpt_ext
