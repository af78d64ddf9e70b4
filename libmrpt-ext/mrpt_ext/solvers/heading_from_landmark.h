#pragma once

#include <optional>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Heading of a robot at `position` that sees `landmark` (both world frame) at `landmark_in_robot` (robot frame).
/// Paper 004, eq 7 and 8: theta = atan2(l - p) - atan2(y_r, x_r). Deviation: atan2 instead of arctan, which makes one
/// formula of the two and holds in all quadrants and for both goals. Nothing when a direction is undefined (robot on
/// the landmark, or non-finite input).
[[nodiscard]] std::optional<double> headingFromLandmark(const Vector2d& landmark, const Vector2d& position,
                                                        const Vector2d& landmark_in_robot);

/// The same from a bearing [rad] measured at the robot centre.
[[nodiscard]] std::optional<double> headingFromBearing(const Vector2d& landmark, const Vector2d& position,
                                                       double bearing);
}  // namespace mrpt_ext
