#pragma once

#include <vector>

#include "mrpt_ext/vision/stereo/marking_points.h"

namespace mrpt_ext
{
/// A straight piece of a marking or of a wall's foot on the floor.
struct FloorLine
{
  Eigen::Vector2d middle{0, 0};     ///< [m]
  Eigen::Vector2d direction{1, 0};  ///< unit
  double first = 0, last = 0;       ///< [m] along `direction` from `middle`
  int points = 0;
};

/// Straight pieces among the points by a Hough transform on the floor, in which each point votes only for the
/// directions its gradients allow. Lines are taken one by one, most votes first; their points do not vote again. An
/// arc gives the chords that follow it within the grid's width.
[[nodiscard]] std::vector<FloorLine> findFloorLines(const std::vector<MarkingPoint>& points, double max_range);
}  // namespace mrpt_ext
