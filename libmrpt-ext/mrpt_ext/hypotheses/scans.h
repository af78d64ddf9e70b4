#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// The anonymous detections of every reading as input of a pose search: one scan per reading, in the same order;
/// readings without such detections are left out. Slant ranges are reduced to the plane and standard deviations
/// inflated as in landmark_measurement.h. Missed detections count only if the reading declares range limit, field of
/// view and detection probability. `index` must be of `map`.
[[nodiscard]] std::vector<Scan> scansOf(std::span<const Reading> readings, const LandmarkTable& map,
                                        const LandmarkIndex& index);
}  // namespace mrpt_ext
