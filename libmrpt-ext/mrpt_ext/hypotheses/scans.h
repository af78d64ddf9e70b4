#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// What each reading saw without being able to name it, ready for a search: one place per reading, in their order;
/// readings without such detections are left out. Slant ranges are reduced to the plane, deviations grown, as in
/// landmark_measurement.h. Landmarks that were not reported count only where the reading declares range limit, field of
/// view and detection probability. `index` must be of `map`.
[[nodiscard]] std::vector<Scan> scansOf(std::span<const Reading> readings, const LandmarkTable& map,
                                        const LandmarkIndex& index);
}  // namespace mrpt_ext
