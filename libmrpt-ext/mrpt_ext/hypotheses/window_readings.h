#pragma once

#include <map>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/solvers/window_landmark.h"
#include "mrpt_ext/solvers/window_pose.h"

namespace mrpt_ext
{
// The readings of a window (relocalization/measurement_window.h), oldest first, as input of the solvers that model the
// odometry errors shared by the readings (solvers/window_pose.h, solvers/window_landmark.h).

/// True if some of the readings were propagated by odometry.
[[nodiscard]] bool isWindow(std::span<const Reading> readings);

/// The reading with the standard deviations of the sensor alone: what odometry has added to the bearings, to the
/// directions of landmarks and to the sensor position is taken off, `odometry_covariance` stays.
[[nodiscard]] Reading withoutOdometryNoise(Reading propagated);

/// The identified detections, one entry per reading that has any.
[[nodiscard]] std::vector<WindowMeasurements> windowMeasurements(std::span<const Reading> oldest_first,
                                                                 const LandmarkTable& map);

/// The identified detections by landmark (index in the map).
[[nodiscard]] std::map<std::size_t, std::vector<WindowObservation>> windowObservations(
    std::span<const Reading> oldest_first, const LandmarkTable& map);
}  // namespace mrpt_ext
