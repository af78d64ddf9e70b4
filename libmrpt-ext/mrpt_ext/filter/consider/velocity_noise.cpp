#include "mrpt_ext/filter/consider/velocity_noise.h"

#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kVelocityMemory = 0.2;  // [s] over which the velocity is averaged
}  // namespace

Matrix3d VelocityNoise::toWorld(const LinearStep& step)
{
  Matrix3d R = Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = rotation(step.predicted.mean[2]);
  return R;
}

KalmanMatrix VelocityNoise::withError(const LinearStep& step) const
{
  KalmanMatrix covariance = KalmanMatrix::Zero(size_, size_);
  covariance.leftCols<3>() = with_error_ * toWorld(step).transpose();
  return covariance;
}

void VelocityNoise::restart()
{
  with_error_.setZero();
  with_response_.clear();
}

void VelocityNoise::predict(const LinearStep& step)
{
  const KalmanMatrix& F = step.motion_jacobian;
  with_error_ = (F * with_error_).eval();
  for (KalmanMatrix& covariance : with_response_) covariance = (F * covariance * F.transpose()).eval();
  with_response_.resize(step.sensor_information.size(), KalmanMatrix::Zero(size_, size_));
  if (!(step.motion.duration > 0)) return;
  const double kept = std::exp(-step.motion.duration / kVelocityMemory);
  weight_ = kept * weight_ + 1 - kept;
  const double newest = (1 - kept) / weight_;
  velocity_ += newest * (step.motion.increment.vector() / step.motion.duration - velocity_);
  KalmanMatrix of_step = KalmanMatrix::Zero(size_, 3);
  of_step.topRows<3>() = step.increment_noise;
  with_error_ = ((1 - newest) * with_error_ + newest / step.motion.duration * of_step).eval();
}

double VelocityNoise::expectedProduct(const LinearStep& step, std::size_t sensor) const
{
  // The derivatives err by -(H_s velocity error + H response error), the innovations are -H error; weighted with the
  // inverse of their covariance.
  const KalmanMatrix remaining = KalmanMatrix::Identity(size_, size_) - step.posterior * step.information;
  const KalmanMatrix of_velocity = step.sensor_information[sensor] * remaining * withError(step);
  const KalmanMatrix of_response = step.information * remaining * with_response_[sensor];
  return of_velocity.trace() + of_response.trace();
}

void VelocityNoise::correct(const LinearStep& step)
{
  const KalmanMatrix& A = step.remaining;
  const KalmanMatrix with_error = withError(step);
  for (std::size_t sensor = 0; sensor < with_response_.size(); ++sensor)
  {
    KalmanMatrix& covariance = with_response_[sensor];
    covariance = (A * covariance * A.transpose()).eval();
    const KalmanMatrix gain = step.posterior * step.sensor_information[sensor];
    covariance -= A * with_error * gain.transpose();
  }
  with_error_ = (A * with_error_).eval();
}
}  // namespace mrpt_ext
