#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// A landmark seen with bearing and range, as a point of the robot frame.
struct ReadingPoint
{
  Vector2d in_robot{0, 0};  ///< [m]
  double std = 0;           ///< [m] in its worst direction
  double spread = 0;        ///< [m^2] product of the deviations along and across the line of sight
  int kind = kAnyCategory;
};

/// The points of all places. One landmark seen from several places gives points that are closer than their errors
/// explain (`gate` standard deviations): they become one, their weighted mean. Detections of a kind that the map does
/// not have, or without a range or a bearing, give none.
[[nodiscard]] std::vector<ReadingPoint> gatherPoints(std::span<const Scan> places, double gate);
}  // namespace mrpt_ext
