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
// Joined readings (relocalization/measurement_window.h) as the solvers want them that know what odometry errors have in
// common. All take the readings oldest first.

/// True when some of the readings were carried along by odometry.
[[nodiscard]] bool isWindow(std::span<const Reading> readings);

/// The reading with the deviations it was taken with: what the way has added to bearings and sensor place is left to
/// `odometry_covariance`.
[[nodiscard]] Reading withoutOdometryNoise(Reading carried);

/// The identified detections of every reading that has some.
[[nodiscard]] std::vector<WindowMeasurements> windowMeasurements(std::span<const Reading> oldest_first,
                                                                 const LandmarkTable& map);

/// The identified detections by landmark (place in the map).
[[nodiscard]] std::map<std::size_t, std::vector<WindowObservation>> windowObservations(
    std::span<const Reading> oldest_first, const LandmarkTable& map);
}  // namespace mrpt_ext
