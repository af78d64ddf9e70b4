#include "mrpt_ext/diagnosis/detection_association.h"

#include <limits>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
namespace
{
constexpr double kInnerGate2 = 16, kOuterGate2 = 49;  // squared standard deviations: a match, and none

/// Squared Mahalanobis distance between a detection and the prediction of a landmark.
double squaredDistance(const Detection& detection, const Reading& reading, const Landmark& landmark,
                       const GaussianPose& robot)
{
  const Vector2d position = landmark.position.head<2>(), offset = reading.T_robot_sensor.position();
  double sum = 0;
  const auto add = [&](double error, const JacobianRow& row, double std)
  { sum += square(error) / (square(std) + row.dot(row * robot.covariance)); };
  if (detection.bearing)
    add(wrap(*detection.bearing - predictBearing(robot.mean, position, reading.T_robot_sensor)),
        bearingJacobian(robot.mean, position, offset), detection.std_bearing);
  if (detection.range)
  {
    const double height = reading.horizontal_range ? 0 : landmark.position.z() - reading.sensor_height;
    add(*detection.range - std::hypot(predictRange(robot.mean, position, reading.T_robot_sensor), height),
        rangeJacobian(robot.mean, position, offset), detection.std_range);
  }
  return sum;
}
}  // namespace

DetectionMatch matchOf(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                       const GaussianPose& robot)
{
  if (detection.id != kNoId) return {map.indexOf(detection.id)};
  double best = std::numeric_limits<double>::infinity(), second = best;
  std::size_t nearest = 0;
  for (std::size_t j = 0; j < map.size(); ++j)
  {
    if (!detection.category.empty() && map[j].category != detection.category) continue;
    const double distance = squaredDistance(detection, reading, map[j], robot);
    if (distance < best)
    {
      second = best;
      best = distance;
      nearest = j;
    }
    else
      second = std::min(second, distance);
  }
  if (best < kInnerGate2 && second >= kOuterGate2) return {nearest};
  return {std::nullopt, best >= kOuterGate2};
}
}  // namespace mrpt_ext
