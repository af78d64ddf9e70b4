#include "mrpt_ext/likelihood/landmark_prediction.h"

#include <algorithm>

#include "mrpt_ext/likelihood/visibility_limits.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinDistance = 1e-6;  // [m] a bearing to a landmark at the sensor itself has no direction

double visibility(const VisibilityLimits& limits, double bearing, double range)
{
  return std::clamp(limits.range_offset - limits.range_slope * range, 0.0, 1.0) *
         std::clamp(limits.bearing_offset - limits.bearing_slope * std::abs(bearing), 0.0, 1.0);
}
}  // namespace

LandmarkPrediction predict(const Landmark& landmark, const Reading& reading, const Pose2& robot)
{
  const Pose2 sensor = compose(robot, reading.T_robot_sensor);
  const double dx = landmark.position.x() - sensor.x, dy = landmark.position.y() - sensor.y;
  const double horizontal2 = std::max(dx * dx + dy * dy, square(kMinDistance));
  const double horizontal = std::sqrt(horizontal2);
  const double dz = reading.horizontal_range ? 0.0 : landmark.position.z() - reading.sensor_height;

  LandmarkPrediction prediction;
  prediction.bearing = wrap(std::atan2(dy, dx) - sensor.phi);
  prediction.range = dz == 0 ? horizontal : std::sqrt(horizontal2 + dz * dz);
  prediction.visibility = visibility(VisibilityLimits(reading.model), prediction.bearing, prediction.range);

  const double ux = dx / horizontal, uy = dy / horizontal;  // line of sight in the world
  Matrix2d position_covariance = landmark.stddev.cwiseAbs2().asDiagonal();
  if (!reading.sensor_position_covariance.isZero(0))
  {
    const Matrix2d R = rotation(robot.phi);
    position_covariance += R * reading.sensor_position_covariance * R.transpose();
  }
  const Matrix2d& C = position_covariance;
  const double along = ux * ux * C(0, 0) + 2 * ux * uy * C(0, 1) + uy * uy * C(1, 1);
  const double across = uy * uy * C(0, 0) - 2 * ux * uy * C(0, 1) + ux * ux * C(1, 1);
  prediction.range_variance = std::max(0.0, along) * square(horizontal / prediction.range);
  prediction.bearing_variance = std::max(0.0, across) / horizontal2;
  return prediction;
}
}  // namespace mrpt_ext
