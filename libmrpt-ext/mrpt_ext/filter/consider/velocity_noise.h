#pragma once

#include <vector>

#include "mrpt_ext/filter/consider/innovation_row.h"

namespace mrpt_ext
{
/// The velocity of the robot by odometry, and what its noise has in common with the innovations.
///
/// A delay shows as innovations that go with the velocity. So does the noise of odometry, which moves the estimate and
/// is in the velocity: without any delay their product has this mean (errors in variables). It is known from the stated
/// noise; the true noise may be less.
class VelocityNoise
{
 public:
  explicit VelocityNoise(Eigen::Index size) : size_(size), with_error_(KalmanMatrix::Zero(size, 3)) {}

  /// After the motion, before the measurement. The velocity then holds the motion of this step, too: a sensor with a
  /// delay errs by what the robot has done meanwhile.
  void predict(const LinearStep& step);
  /// Mean of the products of the innovations of a step with the derivatives by the delay of one sensor.
  [[nodiscard]] double expectedProduct(const LinearStep& step, std::size_t sensor) const;
  /// After the measurement.
  void correct(const LinearStep& step);
  /// The estimate starts anew.
  void restart();

  /// In world axes [m/s, rad/s].
  [[nodiscard]] Vector3d velocity(const LinearStep& step) const { return toWorld(step) * velocity_; }

 private:
  [[nodiscard]] static Matrix3d toWorld(const LinearStep& step);
  /// Covariance of the error of the estimate and that of the velocity (world axes).
  [[nodiscard]] KalmanMatrix withError(const LinearStep& step) const;

  Eigen::Index size_;
  Vector3d velocity_ = Vector3d::Zero();     // axes of the robot
  double weight_ = 0;                        // of what it averages, 1 in the long run
  KalmanMatrix with_error_;                  // E[error of the estimate, error of the velocity^T]
  std::vector<KalmanMatrix> with_response_;  // per sensor: ... that of the estimate's derivative by its delay
};
}  // namespace mrpt_ext
