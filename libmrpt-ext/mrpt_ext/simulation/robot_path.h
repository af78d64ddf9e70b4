#pragma once

#include <vector>

#include "mrpt_ext/geometry/arc_motion.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Constant speed along the robot's forward axis and constant turn rate: a straight line, an arc or a turn in place.
struct TwistSegment
{
  double duration = 0;   ///< [s]
  double speed = 0;      ///< [m/s]
  double turn_rate = 0;  ///< [rad/s] counter-clockwise
};

/// Pose of the robot at any time, at rest before the first segment and after the last.
class RobotPath
{
 public:
  RobotPath(const Pose2& start, const std::vector<TwistSegment>& segments);

  [[nodiscard]] Pose2 poseAt(double time) const;
  /// [m] driven and [rad] turned (absolute values added up) since the start.
  [[nodiscard]] double lengthAt(double time) const;
  [[nodiscard]] double turnedAt(double time) const;
  [[nodiscard]] double duration() const { return legs_.back().begin; }

 private:
  struct Leg
  {
    double begin = 0;  ///< [s]
    Pose2 pose;        ///< at `begin`
    double length = 0, turned = 0;
    TwistSegment motion;
  };
  /// The leg at `time`, and the time since its begin.
  [[nodiscard]] std::pair<const Leg*, double> legAt(double time) const;

  std::vector<Leg> legs_;  ///< the last one is the standstill at the end
};
}  // namespace mrpt_ext
