#pragma once

#include <Eigen/LU>

#include "mrpt_ext/correspondence/local_map/local_map.h"
#include "window_scene.h"

namespace mrpt_ext
{
/// A point of a local map compared with the truth.
struct PointTruth
{
  int landmark = -1;         ///< of most of its detections; -1: clutter
  bool pure = false;         ///< all its detections show that landmark
  bool right = false;        ///< within 4.5 standard deviations of that landmark
  double error = 0;          ///< [m]
  double squared_error = 0;  ///< normalised by its covariance: 2 on average
};

inline PointTruth truthOf(const LocalLandmark& point, const WindowScene& view, const LandmarkIndex& index)
{
  PointTruth truth;
  int most = 0;
  for (const auto& m : point.members)
  {
    const int landmark = view.truth[m.scan][m.detection];
    int same = 0;
    for (const auto& other : point.members) same += view.truth[other.scan][other.detection] == landmark ? 1 : 0;
    if (same > most) truth.landmark = landmark;
    most = std::max(most, same);
  }
  truth.pure = truth.landmark >= 0 && most == static_cast<int>(point.members.size());
  if (truth.landmark < 0) return truth;
  const Vector2d e =
      point.in_robot.mean - transform(inverse(view.robot), index.position(static_cast<std::size_t>(truth.landmark)));
  truth.error = e.norm();
  truth.squared_error = e.dot(point.in_robot.covariance.inverse() * e);
  truth.right = truth.squared_error < square(4.5);
  return truth;
}
}  // namespace mrpt_ext
