#pragma once

#include <span>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// One scalar that a pose explains: a bearing or a range to a known landmark, taken by a sensor anywhere on the robot,
/// or an absolute heading.
struct PoseMeasurement
{
  enum class Kind
  {
    bearing,  ///< [rad, CCW from the sensor's forward axis]
    range,    ///< [m, horizontal, from the sensor]
    heading   ///< [rad] of the robot in the world; the landmark and the sensor pose are not used
  };
  Kind kind = Kind::bearing;
  Vector2d landmark{0, 0};  ///< world frame [m]
  double value = 0;
  double std = 1;  ///< > 0, unit of the value
  Pose2 T_robot_sensor;
};

/// What the measurement should read at `pose`.
[[nodiscard]] inline double predict(const PoseMeasurement& m, const Pose2& pose)
{
  switch (m.kind)
  {
    case PoseMeasurement::Kind::bearing:
      return predictBearing(pose, m.landmark, m.T_robot_sensor);
    case PoseMeasurement::Kind::range:
      return predictRange(pose, m.landmark, m.T_robot_sensor);
    case PoseMeasurement::Kind::heading:
      return wrap(pose.phi);
  }
  return 0;
}

/// Predicted minus measured, wrapped for angles.
[[nodiscard]] inline double residual(const PoseMeasurement& m, const Pose2& pose)
{
  const double difference = predict(m, pose) - m.value;
  return m.kind == PoseMeasurement::Kind::range ? difference : wrap(difference);
}

/// Row of the Jacobian at `pose`.
[[nodiscard]] inline JacobianRow jacobian(const PoseMeasurement& m, const Pose2& pose)
{
  switch (m.kind)
  {
    case PoseMeasurement::Kind::bearing:
      return bearingJacobian(pose, m.landmark, m.T_robot_sensor.position());
    case PoseMeasurement::Kind::range:
      return rangeJacobian(pose, m.landmark, m.T_robot_sensor.position());
    case PoseMeasurement::Kind::heading:
      return {0, 0, 1};
  }
  return JacobianRow::Zero();
}

/// Finite everywhere, positive standard deviation, no negative range.
[[nodiscard]] inline bool isUsable(const PoseMeasurement& m)
{
  const bool finite = m.landmark.allFinite() && std::isfinite(m.value) && isFinite(m.T_robot_sensor);
  return finite && m.std > 0 && std::isfinite(m.std) && (m.kind != PoseMeasurement::Kind::range || m.value >= 0);
}
}  // namespace mrpt_ext
