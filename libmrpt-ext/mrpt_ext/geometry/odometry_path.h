#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/odometry_jumps.h"
#include "mrpt_ext/geometry/pose_estimate.h"
#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext
{
/// Calibration of the odometry of a log.
struct OdometryCorrection
{
  double scale = 1;              ///< factor on distances
  double distance_per_turn = 0;  ///< [m/rad] added to the measured distance per measured turn while driving
  double rotation_scale = 1;     ///< factor on rotations
  double pivot_scale = 1;        ///< factor on rotations in place, beside rotation_scale
  double yaw = 0;                ///< [rad] of the x axis of odometry on the robot, to the left
  double turn_per_m = 0;         ///< [rad/m] added to the heading per metre driven
  double turn_per_s = 0;         ///< [rad/s] added to the heading per second
  double delay = 0;              ///< [s] added to the stamps
};

/// Dead-reckoned trajectory of a whole log, or of its newest part: the pose at any time, and the motion between two
/// times.
class OdometryPath
{
 public:
  OdometryPath() = default;
  explicit OdometryPath(const OdometryCorrection& correction) : correction_(correction) {}
  /// Records in any order of time, of a path without jumps, corrected as configured.
  OdometryPath(std::vector<OdometryRecord> records, const OdometryCorrection& correction);

  /// A record that is not earlier than those before. A jump (odometry_jumps.h) is no motion.
  void add(const OdometryRecord& record);
  /// Later calls concern `time` and what follows: the records before it may be dropped.
  void forgetBefore(double time);
  [[nodiscard]] bool empty() const { return path_.empty(); }
  /// Interpolated between records; constant before the first and after the last.
  [[nodiscard]] Pose2 at(double time) const;
  [[nodiscard]] OdometryMotion between(double from, double to) const;
  [[nodiscard]] const Trajectory& trajectory() const { return path_; }
  [[nodiscard]] const OdometryJumps& jumps() const { return jumps_; }

 private:
  void appendStep(const OdometryRecord& record, bool is_jump);
  /// Sums from the start to a time.
  struct PathPoint
  {
    Pose2 pose;
    double length = 0, turned = 0;
  };
  [[nodiscard]] PathPoint pointAt(double time) const;
  /// Number of the first record after `time`.
  [[nodiscard]] std::size_t firstAfter(double time) const;
  /// Of the path between two times, at which it is at `begin` and `end`; nothing when no record is between them.
  [[nodiscard]] std::optional<PathMoments> momentsBetween(double from, const PathPoint& begin, double to,
                                                          const PathPoint& end) const;

  OdometryCorrection correction_;
  OdometryRecord logged_;  // added last, not corrected
  OdometryJumps jumps_;
  Trajectory path_;
  std::vector<double> length_, turned_;  // accumulated, one per pose of path_
};

/// Motion between two times by dead reckoning: the later pose in the frame of the earlier one. Odometry is interpolated
/// over gaps of any length and holds its first and last pose outside; without odometry: identity.
[[nodiscard]] Pose2 motionBetween(const Trajectory& odometry, double from, double to);

/// The estimate propagated to `time` by dead reckoning, covariance included; odometry's own noise is not added. An
/// estimate without a heading stays where it is: the direction of the motion is unknown.
[[nodiscard]] PoseEstimate propagate(const PoseEstimate& estimate, const Trajectory& odometry, double time);
}  // namespace mrpt_ext
