#include "mrpt_ext/diagnosis/detection_association.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

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

/// Calls `take` with the number and the squared distance of every landmark of the category.
template <typename Take>
void forEachCandidate(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                      const GaussianPose& robot, const Take& take)
{
  for (std::size_t j = 0; j < map.size(); ++j)
    if (detection.category.empty() || map[j].category == detection.category)
      take(j, squaredDistance(detection, reading, map[j], robot));
}
}  // namespace

DetectionMatch matchOf(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                       const GaussianPose& robot)
{
  if (detection.id != kNoId) return {map.indexOf(detection.id)};
  double best = std::numeric_limits<double>::infinity(), second = best;
  std::size_t nearest = 0;
  forEachCandidate(detection, reading, map, robot,
                   [&](std::size_t j, double distance)
                   {
                     if (distance < best)
                     {
                       second = best;
                       best = distance;
                       nearest = j;
                     }
                     else
                       second = std::min(second, distance);
                   });
  if (best < kInnerGate2 && second >= kOuterGate2) return {nearest};
  return {std::nullopt, best >= kOuterGate2};
}

std::optional<LandmarkMixture> mixtureOf(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                                         const GaussianPose& robot)
{
  if (!detection.bearing || !detection.range) return std::nullopt;
  std::vector<std::pair<double, std::size_t>> near;  // weight and number
  forEachCandidate(detection, reading, map, robot,
                   [&](std::size_t j, double distance)
                   {
                     if (distance < kInnerGate2) near.emplace_back(std::exp(-0.5 * distance), j);
                   });
  if (near.empty()) return std::nullopt;
  LandmarkMixture mixture{.likeliest = std::max_element(near.begin(), near.end())->second};
  double sum = 0;
  for (const auto& [weight, j] : near)
  {
    sum += weight;
    mixture.mean += weight * map[j].position.head<2>();
  }
  mixture.mean /= sum;
  double bearing = square(detection.std_bearing), range = square(detection.std_range);
  const double to_mean = predictBearing(robot.mean, mixture.mean, reading.T_robot_sensor),
               distance_to_mean = predictRange(robot.mean, mixture.mean, reading.T_robot_sensor);
  for (const auto& [weight, j] : near)
  {
    const Vector2d position = map[j].position.head<2>();
    bearing += weight / sum * square(wrap(predictBearing(robot.mean, position, reading.T_robot_sensor) - to_mean));
    range += weight / sum * square(predictRange(robot.mean, position, reading.T_robot_sensor) - distance_to_mean);
  }
  mixture.std_bearing = std::sqrt(bearing);
  mixture.std_range = std::sqrt(range);
  return mixture;
}
}  // namespace mrpt_ext
