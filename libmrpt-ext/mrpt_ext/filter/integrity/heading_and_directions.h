#pragma once

#include <Eigen/Dense>

namespace mrpt_ext
{
/// Joint covariance of the errors of a robot's heading by odometry and of the directions in which it saw static
/// features, as of a SLAM filter without positions: an error-state Kalman filter whose corrections the owner applies to
/// the angles. A feature that is seen again tells how odometry's heading has drifted, and so where the others are.
class HeadingAndDirections
{
 public:
  /// Number of directions.
  [[nodiscard]] Eigen::Index size() const { return covariance_.rows() - 1; }

  /// The robot turned: the heading drifts by this variance [rad^2].
  void turn(double variance) { covariance_(0, 0) += variance; }
  /// A new direction, the last one: the heading plus a bearing of this variance [rad^2].
  void add(double variance);
  void remove(Eigen::Index direction);

  /// Variance [rad^2] of the bearing that the direction has now: of its difference to the heading.
  [[nodiscard]] double bearingVariance(Eigen::Index direction) const;

  /// Corrections [rad] after a bearing of the direction.
  struct Correction
  {
    double heading = 0;
    Eigen::VectorXd directions;
  };
  /// `innovation`: measured minus predicted bearing, with the measurement's `variance`, and `spread`, the variance of
  /// the prediction among the ranges that the feature may have, given the bearing. The bearing of the direction is
  /// known no better than one measurement tells: errors of bearings last.
  Correction update(Eigen::Index direction, double innovation, double variance, double spread);

 private:
  Eigen::MatrixXd covariance_ = Eigen::MatrixXd::Zero(1, 1);  // the heading first
};
}  // namespace mrpt_ext
