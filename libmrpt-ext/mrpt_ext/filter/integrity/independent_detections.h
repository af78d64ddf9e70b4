#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/filter/motion/dead_reckoning.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// How far the robot has to move between independent detections of one landmark [m]: 0.3 m,
/// or 2 % of the diagonal of the map if that is less.
[[nodiscard]] double decorrelationDistance(const LandmarkTable& map);

/// Separates independent detections from temporally correlated ones.
///
/// Detections of one landmark from one spot share their errors (calibration, map, occlusion): fifty of them are not
/// fifty independent measurements. A detection counts as independent when no detection of the same landmark, or if it
/// is anonymous none in a similar direction by odometry, was made since the robot last was decorrelationDistance() from
/// here. Without odometry (random walk) the distance is
/// the standard deviation of the motion in the meantime.
class DetectionDecorrelator
{
 public:
  DetectionDecorrelator(const MotionModel& motion, const LandmarkTable& map);

  void clear() { recent_.clear(); }
  void move(const OdometryMotion& motion);
  /// The reading in two. Neither part declares a detection probability any more: only whole readings show what was
  /// missed.
  struct Split
  {
    Reading independent, correlated;
  };
  /// The independent detections are remembered.
  [[nodiscard]] Split split(const Reading& reading);
  /// The independent part of split().
  [[nodiscard]] Reading independent(const Reading& reading);
  /// The reading without correlated anonymous bearings: many wrong poses fit them as well as the right one. With a
  /// range a detection separates poses at once, and stays. Unchanged where nothing is left out; all of it is
  /// remembered.
  [[nodiscard]] Reading withoutCorrelatedBearings(const Reading& reading);

 private:
  /// A detection in odometry's axes: where the robot was, and the direction [rad].
  struct RecentDetection
  {
    std::string sensor;
    Detection detection;
    DeadReckoning from;
    double direction = 0;
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
