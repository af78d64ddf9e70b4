#pragma once

#include <Eigen/Core>
#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
/// One number that was measured, linearized at the predicted pose.
struct ScalarMeasurement
{
  double residual = 0;         ///< measured minus predicted [rad] or [m]
  double std = 0;              ///< of the noise, as declared
  JacobianRow pose;            ///< of the prediction, by the pose
  Eigen::RowVectorXd unknown;  ///< of the measurement, by the systematic errors
};

/// An innovation in units of its standard deviation: sensitivity * systematic errors + white noise.
struct SensitiveInnovation
{
  double value = 0;
  double std = 0;                  ///< [rad] or [m]
  Eigen::RowVectorXd sensitivity;  ///< by the systematic errors
};

/// A Kalman filter of the pose that knows nothing of systematic errors, beside the sensitivity of its own error to
/// them: the first stage of Friedland's two-stage bias estimation (IEEE Transactions on Automatic Control 14(4), 1969).
/// A filter follows biased measurements, so its innovations show only what it could not follow; the sensitivities
/// account for that.
class BiasFreeFilter
{
 public:
  BiasFreeFilter(std::vector<CalibrationUnknown> unknowns, const MotionModel& motion);

  void start(const GaussianPose& pose);
  /// `smooth`: the same motion as the average over about a second says, in the frame of the robot before. The
  /// sensitivities follow it, because they must not contain the noise of the innovations. `noise`: covariance of the
  /// increment, which must not contain it either (link_noise.h).
  void predict(const OdometryMotion& motion, const OdometryMotion& smooth, const Matrix3d& noise);
  void predict(const OdometryMotion& motion) { predict(motion, motion, incrementCovariance(motion_, motion)); }
  [[nodiscard]] SensitiveInnovation innovation(const ScalarMeasurement& measurement) const;
  void update(const ScalarMeasurement& measurement);

  [[nodiscard]] const std::vector<CalibrationUnknown>& unknowns() const { return unknowns_; }
  [[nodiscard]] const GaussianPose& pose() const { return pose_; }
  /// Of (estimate minus truth) by the systematic errors.
  [[nodiscard]] const Eigen::Matrix<double, 3, Eigen::Dynamic>& sensitivity() const { return sensitivity_; }

 private:
  std::vector<CalibrationUnknown> unknowns_;
  MotionModel motion_;
  GaussianPose pose_;
  Eigen::Matrix<double, 3, Eigen::Dynamic> sensitivity_;
};
}  // namespace mrpt_ext
