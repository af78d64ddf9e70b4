#pragma once

#include <optional>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/geometry/trajectory.h"
#include "mrpt_ext/simulation/robot_path.h"
#include "mrpt_ext/simulation/scenario.h"

namespace mrpt_ext
{
/// Dead reckoning: the increments of the path, each with its own error, added up from (0, 0, 0).
class SimulatedOdometry
{
 public:
  /// Records from 0 to at least `duration` [s], `noise.rate_hz` of them per second; poses rounded to 1e-6.
  SimulatedOdometry(const RobotPath& path, const OdometryNoise& noise, double duration, RandomStream& random);

  [[nodiscard]] const Trajectory& records() const { return records_; }

  /// Motion from `begin` to `end` [s] as logged, later pose in the frame of the earlier, with the covariance of the
  /// accumulated errors. Nothing outside the records.
  [[nodiscard]] std::optional<GaussianPose> displacement(double begin, double end) const;

 private:
  /// Measured / true rotation.
  [[nodiscard]] double rotationScale(double begin, double end) const;
  /// What a slip within this time adds to the measured motion; nearly always nothing.
  [[nodiscard]] Vector3d slip(double duration, RandomStream& random) const;
  [[nodiscard]] Vector3d incrementStd(double begin, double end) const;

  RobotPath path_;
  OdometryNoise noise_;
  Trajectory records_;
};
}  // namespace mrpt_ext
