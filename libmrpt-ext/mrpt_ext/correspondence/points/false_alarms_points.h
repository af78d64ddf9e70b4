#pragma once

#include <span>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/points/scan_points.h"

namespace mrpt_ext
{
/// Statistics of poses that points support by chance.
struct PointFalseAlarmModel
{
  double poses_per_pair = 0;  ///< wrong poses of two points of known distance in the map
  double chance = 0;          ///< that a point has a landmark within its gate at a wrong pose
  int points = 0;
};

/// For landmarks spread with density rho over the map: two points a distance s apart, known to +-t, are matched by N
/// landmarks each with 2 pi s 2 t rho others, so poses_per_pair = 4 pi N rho s t; t is k times the deviation of a
/// distance, whatever its direction. A further point is matched within k standard deviations in range and in bearing,
/// each enlarged by the error of the pose: an area A contains a landmark with probability 1 - exp(-A rho). Categories
/// divide rho by their number where all points have one.
[[nodiscard]] PointFalseAlarmModel pointFalseAlarmModel(const LandmarkIndex& map, std::span<const ScanPoint> points,
                                                        double gate);

/// Expected number of wrong poses with at least `matched` inliers: with K points and T poses per pair,
///   E = T C(K, 2) / C(m, 2) P(at least m - 2 of K - 2 match by chance),
/// as for bearings (false_alarms_bearings.h), with two points instead of three bearings fixing a pose. C(K, 2) / C(m,
/// 2) counts the poses that a given pair cannot propose because one of its points is an outlier.
[[nodiscard]] double expectedFalsePoses(const PointFalseAlarmModel& chance, int matched);
}  // namespace mrpt_ext
