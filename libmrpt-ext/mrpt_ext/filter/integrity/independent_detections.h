#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/filter/motion/dead_reckoning.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// Separates independent detections from temporally correlated ones.
///
/// Detections of one landmark from one spot share their errors (calibration, map, occlusion): fifty of them are not
/// fifty independent measurements. A detection counts as independent when no similar one was made in that direction, by
/// odometry, since the robot last was a minimal distance from here: 0.3 m, or 2 % of the map's diagonal if that is
/// less.
class DetectionDecorrelator
{
 public:
  DetectionDecorrelator(const MotionModel& motion, const LandmarkTable& map);

  void clear() { recent_.clear(); }
  void move(const OdometryMotion& motion);
  /// The reading with its independent detections only; they are remembered. It declares no detection probability any
  /// more: only whole readings show what was missed.
  [[nodiscard]] Reading independent(const Reading& reading);
  /// The reading without correlated anonymous bearings: many wrong poses fit them as well as the right one. With a
  /// range a detection separates poses at once, and stays. Unchanged where nothing is left out; all of it is
  /// remembered.
  [[nodiscard]] Reading withoutCorrelatedBearings(const Reading& reading);

 private:
  /// A detection in odometry's axes: sensor position [m] and direction [rad].
  struct RecentDetection
  {
    std::string sensor;
    Detection detection;
    Vector2d from;
    double direction = 0;
    double heading_variance = 0;  ///< of odometry, since the start [rad^2]
  };

  [[nodiscard]] RecentDetection inOdometryAxes(const Reading& reading, const Detection& detection) const;
  [[nodiscard]] bool isCorrelated(const RecentDetection& detection) const;
  /// Which detections are independent; all of those are remembered.
  [[nodiscard]] std::vector<bool> markIndependent(const Reading& reading);

  MotionModel motion_;
  double min_distance_;     // [m]
  DeadReckoning odometry_;  // since the start
  std::vector<RecentDetection> recent_;
};
}  // namespace mrpt_ext
