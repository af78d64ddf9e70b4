#pragma once

#include <Eigen/Dense>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Static points as a robot without a map knows them: a Kalman filter over their positions in the axes of the robot [m]
/// (robocentric SLAM; Castellanos, Martinez-Cantin, Tardos, Neira, Robotics and Autonomous Systems 55(1), 2007). What
/// odometry errs by is common to all points, so one that is seen again tells where the others are.
class RelativePoints
{
 public:
  [[nodiscard]] Eigen::Index size() const { return positions_.size() / 2; }
  [[nodiscard]] Vector2d position(Eigen::Index point) const { return positions_.segment<2>(2 * point); }
  [[nodiscard]] Matrix2d covariance(Eigen::Index point) const { return covariance_.block<2, 2>(2 * point, 2 * point); }

  /// The robot moved by `step`, known with this covariance of x, y [m], phi [rad] in the axes that it had before.
  void move(const Pose2& step, const Matrix3d& covariance);
  /// A new point, the last one.
  void add(const Vector2d& position, const Matrix2d& covariance);
  void remove(Eigen::Index point);
  /// The point was measured there, with this covariance. In no direction it is then known better than one measurement
  /// tells: errors of sensors last.
  void update(Eigen::Index point, const Vector2d& measured, const Matrix2d& covariance);

 private:
  Eigen::VectorXd positions_;   // x, y of each
  Eigen::MatrixXd covariance_;  // of all of them
};
}  // namespace mrpt_ext
