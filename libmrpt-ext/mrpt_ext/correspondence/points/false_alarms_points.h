#pragma once

#include <span>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/points/scan_points.h"

namespace mrpt_ext
{
/// What chance has to work with when a constellation of points is sought where it is not.
struct PointFalseAlarmModel
{
  double poses_per_pair = 0;  ///< wrong poses that two points of known distance have in the map
  double chance = 0;          ///< that a point has a landmark within its gate at a wrong pose
  int points = 0;
};

/// For landmarks strewn with density rho over the map: two points a distance s apart, known to +-t, are matched by N
/// landmarks each with 2 pi s 2 t rho others, so poses_per_pair = 4 pi N rho s t; t is k times the deviation of a
/// distance, whatever its direction. A further point is matched within k deviations in range and in bearing, each
/// enlarged by the error of the pose: in this area A a landmark lies with chance 1 - exp(-A rho).
/// Categories divide rho by their number where all points tell theirs.
[[nodiscard]] PointFalseAlarmModel pointFalseAlarmModel(const LandmarkIndex& map, std::span<const ScanPoint> points,
                                                        double gate);

/// Expected number of wrong poses that explain at least `matched` of the points: with K points and T poses per pair,
///   E = T C(K, 2) / C(m, 2) P(at least m - 2 of K - 2 hit by chance),
/// the form of equations.md section 2 with two points instead of three bearings fixing a pose. C(K, 2) / C(m, 2)
/// counts the poses that a given pair cannot propose because one of its points is unexplained.
[[nodiscard]] double expectedFalsePoses(const PointFalseAlarmModel& chance, int matched);
}  // namespace mrpt_ext
