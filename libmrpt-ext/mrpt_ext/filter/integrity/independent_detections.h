#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/filter/motion/dead_reckoning.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// When a landmark that was seen is looked at again, not just seen still.
struct DecorrelationOptions
{
  double share = 0.02;   ///< of the map's diagonal: the way after which the same direction is a fresh look ...
  double longest = 0.3;  ///< [m] ... or this, whichever is less
};

/// Tells fresh looks from repeated ones. The same thing seen again and again from one spot shares its errors (of
/// calibration, of the map, of what stands in the way of what): fifty readings of it are not fifty witnesses for one
/// place and against another. A look is fresh when nothing like it was seen in that direction, as odometry tells
/// directions, since the robot last was a piece of way from here.
class DetectionDecorrelator
{
 public:
  DetectionDecorrelator(const DecorrelationOptions& spacing, const MotionModel& motion, const LandmarkTable& map);

  void clear() { looks_.clear(); }
  void move(const OdometryMotion& motion);
  /// The reading with its fresh detections only; they are remembered. It declares no detection probability any more:
  /// what was missed is told by whole readings.
  [[nodiscard]] Reading take(const Reading& reading);
  /// The reading without repeated bearings that have no name: many wrong places explain them as well as the right one.
  /// With a range they tell places apart at once. Unchanged where none is; what it shows is remembered.
  [[nodiscard]] Reading withoutCorrelatedBearings(const Reading& reading);

 private:
  /// Something seen, as odometry tells where: way so far [m], direction in odometry's axes [rad].
  struct Look
  {
    std::string sensor;
    Detection detection;
    Vector2d from;
    double direction = 0;
    double heading_variance = 0;  ///< of odometry, since the start [rad^2]
  };

  [[nodiscard]] Look lookOf(const Reading& reading, const Detection& detection) const;
  [[nodiscard]] bool isRepeat(const Look& look) const;
  /// Which detections are fresh; all of those are remembered.
  [[nodiscard]] std::vector<bool> freshOnes(const Reading& reading);

  MotionModel motion_;
  double look_way_;
  DeadReckoning odometry_;  // since the start
  std::vector<Look> looks_;
};
}  // namespace mrpt_ext
