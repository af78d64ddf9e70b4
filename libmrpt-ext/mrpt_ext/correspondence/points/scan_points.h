#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// A landmark seen with bearing and range, as a point of the robot frame.
struct ScanPoint
{
  Vector2d in_robot{0, 0};  ///< [m]
  double std = 0;           ///< [m] in its worst direction
  double spread = 0;        ///< [m^2] product of the deviations along and across the line of sight
  int category = kAnyCategory;
};

/// The points of all scans. One landmark seen from several scans gives points that are closer than their errors
/// explain (`gate` standard deviations): they become one, their weighted mean. Detections of a category that the map
/// does not have, or without a range or a bearing, give none.
[[nodiscard]] std::vector<ScanPoint> gatherPoints(std::span<const Scan> scans, double gate);
}  // namespace mrpt_ext
