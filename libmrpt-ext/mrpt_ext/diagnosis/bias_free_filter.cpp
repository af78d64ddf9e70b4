#include "mrpt_ext/diagnosis/bias_free_filter.h"

namespace mrpt_ext
{
namespace
{
/// Of the error of the estimate, in axes of the motion's begin, by an error of odometry that it was measured with.
Vector3d odometryEffect(CalibrationParameter parameter, const OdometryMotion& motion)
{
  switch (parameter)
  {
    case CalibrationParameter::distance_scale:
      return {-motion.increment.x, -motion.increment.y, 0};
    case CalibrationParameter::rotation_scale:
      return -momentsOf(motion).by_turn;
    case CalibrationParameter::veer:
      return -momentsOf(motion).by_length;
    case CalibrationParameter::drift:
      return -momentsOf(motion).by_time;
    default:
      return Vector3d::Zero();
  }
}
}  // namespace

BiasFreeFilter::BiasFreeFilter(std::vector<CalibrationUnknown> unknowns, const MotionModel& motion)
    : unknowns_(std::move(unknowns)), motion_(motion)
{
  sensitivity_.setZero(3, static_cast<Eigen::Index>(unknowns_.size()));
}

void BiasFreeFilter::start(const GaussianPose& pose)
{
  pose_ = pose;
  sensitivity_.setZero();
}

void BiasFreeFilter::predict(const OdometryMotion& measured, const OdometryMotion& smooth, const Matrix3d& noise)
{
  const OdometryMotion motion = nominalMotion(motion_, measured);
  const Vector2d step = rotation(pose_.mean.phi) * motion.increment.position();
  Matrix3d transition = Matrix3d::Identity(), to_map = Matrix3d::Identity();
  transition(0, 2) = -step.y();
  transition(1, 2) = step.x();
  to_map.topLeftCorner<2, 2>() = rotation(pose_.mean.phi);
  pose_.covariance = transition * pose_.covariance * transition.transpose() + to_map * noise * to_map.transpose();
  sensitivity_ = (transition * sensitivity_).eval();
  for (std::size_t k = 0; k < unknowns_.size(); ++k)
    sensitivity_.col(static_cast<Eigen::Index>(k)) += to_map * odometryEffect(unknowns_[k].parameter, smooth);
  pose_.mean = compose(pose_.mean, motion.increment);
}

SensitiveInnovation BiasFreeFilter::innovation(const ScalarMeasurement& m) const
{
  const double std = std::sqrt(square(m.std) + m.pose.dot(m.pose * pose_.covariance));
  return {m.residual / std, std, (m.unknown - m.pose * sensitivity_) / std};
}

void BiasFreeFilter::update(const ScalarMeasurement& m)
{
  const SensitiveInnovation found = innovation(m);
  const Vector3d gain = pose_.covariance * m.pose.transpose() / square(found.std);
  const Vector3d step = gain * m.residual;
  pose_.mean = {pose_.mean.x + step.x(), pose_.mean.y + step.y(), wrap(pose_.mean.phi + step.z())};
  sensitivity_ += gain * found.sensitivity * found.std;
  const Matrix3d reduced = Matrix3d::Identity() - gain * m.pose;
  pose_.covariance =
      (reduced * pose_.covariance * reduced.transpose() + square(m.std) * gain * gain.transpose()).eval();
}
}  // namespace mrpt_ext
