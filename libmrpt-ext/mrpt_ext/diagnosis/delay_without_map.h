#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
/// How late odometry is against the sensors [s], positive: the robot makes its motions that much after their stamps.
struct RelativeDelay
{
  double delay = 0, std = 0;
};

/// The delay that bearings tell without a map, a pose or identities. What a sensor sees twice within a second has moved
/// to the side as the robot turned in between. For each delay, a bearing is expected where one of the reading before it
/// is after the motion that odometry had that much earlier, at a typical range and up to its parallax, or anywhere as
/// what comes into view; the likeliest delay within half a second before and one after counts. Its deviation: jackknife
/// over blocks of time. `readings` in order of time; `typical_range` [m] of what is seen, for the parallax. Nothing
/// where bearings do not tell it within 0.1 s.
[[nodiscard]] std::optional<RelativeDelay> delayWithoutMap(const std::vector<Reading>& readings,
                                                           const OdometryPath& odometry, double typical_range);
}  // namespace mrpt_ext
