#pragma once

#include "mrpt_ext/calibration/motion_noise.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
/// Noise of the motion between two times, for an estimator that weighs odometry against readings.
///
/// The noise grows with the way and with the turn. Were these the measured ones, what odometry measures too long would
/// count less than what it measures too short, and all of it would appear to be measured too short: for a turn of 8 deg
/// that is known to 1.7 deg, by the square of that, 4 %. They are those of the motion before and after instead, whose
/// noise is another one.
class LinkNoise
{
 public:
  /// `odometry` must outlive it.
  LinkNoise(const MotionModel& model, const OdometryPath& odometry) : model_(model), odometry_(odometry) {}

  /// Covariances of the increment (x, y, phi) [m^2, m rad, rad^2], in axes of the motion's begin, by what errs; times
  /// in s.
  [[nodiscard]] PerMotionNoise<Matrix3d> covariances(double from, double to) const;

 private:
  [[nodiscard]] Pose2 moved(double from, double to) const;
  [[nodiscard]] double turnBeyondNoise(const Pose2& moved, double duration) const;

  MotionModel model_;
  const OdometryPath& odometry_;
};
}  // namespace mrpt_ext
