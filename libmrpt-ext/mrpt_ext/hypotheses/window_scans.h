#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/local_map/past_scan.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/work_budget.h"

namespace mrpt_ext
{
/// The anonymous detections of a window, oldest first, with the covariance of the odometry since each scan.
[[nodiscard]] std::vector<PastScan> pastScans(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                              const LandmarkIndex& index);

/// The anonymous detections of a window, merged into a local map (local_map.h): the first scan holds its points, the
/// others the detections left over. Of long windows some readings are taken (informative_readings.h). Readings of a
/// single frame give the same as scansOf().
[[nodiscard]] std::vector<Scan> windowScans(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                            const LandmarkIndex& index, WorkBudget& budget);
}  // namespace mrpt_ext
