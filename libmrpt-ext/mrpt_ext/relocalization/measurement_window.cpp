#include "mrpt_ext/relocalization/measurement_window.h"

#include <cmath>

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
namespace
{
/// `covariance` of the odometry since a reading, propagated over one more increment with covariance `S`; in the axes of
/// the robot before and after it.
Matrix3d propagated(const Matrix3d& covariance, const Pose2& increment, const Matrix3d& S)
{
  const Matrix3d P = compound({{}, covariance}, increment, S).covariance;
  const Matrix3d to_end_axes = composeJacobianSecond({0, 0, -increment.phi});
  return to_end_axes * P * to_end_axes.transpose();
}

/// Propagates a reading to a robot that has moved by `motion`, with covariance `S`.
void propagate(Reading& reading, const OdometryMotion& motion, const Matrix3d& S)
{
  const Vector2d lever = reading.T_robot_sensor.position() - motion.increment.position();
  const Vector2d swing(-lever.y(), lever.x());  // a heading error rotates the old position about the new one
  const Matrix2d R = rotation(-motion.increment.phi);
  const Matrix2d cross = S.topRightCorner<2, 1>() * swing.transpose();
  const Matrix2d inflated = reading.sensor_position_covariance + S.topLeftCorner<2, 2>() +
                            S(2, 2) * swing * swing.transpose() + cross + cross.transpose();
  reading.sensor_position_covariance = R * inflated * R.transpose();
  reading.odometry_covariance = propagated(reading.odometry_covariance, motion.increment, S);
  for (Detection& detection : reading.detections)
  {
    if (detection.bearing) detection.std_bearing = std::hypot(detection.std_bearing, std::sqrt(S(2, 2)));
    if (detection.facing) detection.facing = widened(*detection.facing, S(2, 2));
  }
  reading.T_robot_sensor = compose(inverse(motion.increment), reading.T_robot_sensor);
  reading.model.detection_probability.reset();  // missed detections do not apply to the new pose
}
}  // namespace

void MeasurementWindow::add(const Frame& frame)
{
  if (!first_time_) first_time_ = frame.time;
  full_ = frame.time - *first_time_ >= window_;
  for (Reading& reading : newest_.readings) older_.push_back(std::move(reading));
  while (!older_.empty() && older_.front().time < frame.time - window_) older_.pop_front();
  const OdometryMotion motion = nominalMotion(motion_, frame.motion);
  const Matrix3d S = incrementCovariance(motion_, frame.motion);
  for (Reading& reading : older_) propagate(reading, motion, S);
  newest_ = frame;
}

std::vector<Reading> MeasurementWindow::readings() const
{
  std::vector<Reading> all(older_.begin(), older_.end());
  all.insert(all.end(), newest_.readings.begin(), newest_.readings.end());
  return all;
}

Frame MeasurementWindow::frame() const
{
  Frame frame = newest_;
  frame.readings = readings();
  return frame;
}
}  // namespace mrpt_ext
