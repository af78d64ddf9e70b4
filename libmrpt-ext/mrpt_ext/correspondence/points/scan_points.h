#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// A landmark detected with bearing and range, as a point of the robot frame.
struct ScanPoint
{
  Vector2d in_robot{0, 0};  ///< [m]
  double std = 0;           ///< [m] in its worst direction
  double spread = 0;        ///< [m^2] product of the standard deviations along and across the line of sight
  int category = kAnyCategory;
};

/// The points of all scans. Points of different scans within `gate` standard deviations of one another are one
/// landmark: they become one point, their weighted mean. Detections of a category that the map does not have, or
/// without range or bearing, give none.
[[nodiscard]] std::vector<ScanPoint> gatherPoints(std::span<const Scan> scans, double gate);
}  // namespace mrpt_ext
