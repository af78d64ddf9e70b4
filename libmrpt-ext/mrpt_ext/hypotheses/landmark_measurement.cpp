#include "mrpt_ext/hypotheses/landmark_measurement.h"

#include "mrpt_ext/likelihood/facing_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTypicalDistance = 3.0;  // [m] converts a position error into a bearing error if no range is measured

/// Horizontal range; nothing if the slant range is shorter than the difference in height.
std::optional<double> horizontalRange(const Reading& reading, double slant, double landmark_height)
{
  if (reading.horizontal_range) return slant;
  const double dz = landmark_height - reading.sensor_height;
  const double horizontal2 = slant * slant - dz * dz;
  if (!(horizontal2 > 0)) return std::nullopt;
  return std::sqrt(horizontal2);
}

LandmarkMeasurement reduce(const Reading& reading, const Detection& detection, double landmark_height,
                           const Vector2d& landmark_std)
{
  LandmarkMeasurement m;
  m.category = detection.category;
  m.T_robot_sensor = reading.T_robot_sensor;
  m.bearing = detection.bearing;
  // The line of sight is not known yet: the larger of the two axes is used for every direction.
  const double extra = std::max(reading.sensor_position_covariance(0, 0), reading.sensor_position_covariance(1, 1)) +
                       square(landmark_std.maxCoeff());
  if (detection.range)
  {
    m.range = horizontalRange(reading, *detection.range, landmark_height);
    // d horizontal / d slant = slant / horizontal
    if (m.range) m.std_range = std::sqrt(square(detection.std_range * *detection.range / *m.range) + extra);
  }
  const double distance = m.range.value_or(kTypicalDistance);
  m.std_bearing = std::sqrt(square(detection.std_bearing) + extra / square(distance));
  return m;
}
}  // namespace

Vector2d LandmarkMeasurement::pointInRobot() const
{
  return transform(T_robot_sensor, *range * Vector2d(std::cos(*bearing), std::sin(*bearing)));
}

Matrix2d LandmarkMeasurement::pointCovariance() const
{
  const Matrix2d R = rotation(T_robot_sensor.phi + *bearing);
  const Matrix2d along_across = Vector2d(square(std_range), square(*range * std_bearing)).asDiagonal();
  return R * along_across * R.transpose();
}

std::vector<LandmarkMeasurement> identifiedMeasurements(std::span<const Reading> readings, const LandmarkTable& map)
{
  std::vector<LandmarkMeasurement> result;
  for (const Reading& reading : readings)
    for (const Detection& detection : reading.detections)
    {
      const auto known = map.indexOf(detection.id);
      if (!known) continue;
      LandmarkMeasurement m = reduce(reading, detection, map[*known].position.z(), map[*known].stddev);
      m.landmark = known;
      m.position = map[*known].position.head<2>();
      m.headings = headingFromFacing(detection, reading, map);
      if (m.bearing || m.range) result.push_back(std::move(m));
    }
  return result;
}

std::vector<LandmarkMeasurement> anonymousMeasurements(std::span<const Reading> readings, const LandmarkTable& map)
{
  std::vector<LandmarkMeasurement> result;
  for (const Reading& reading : readings)
    for (const Detection& detection : reading.detections)
    {
      if (detection.id != kNoId) continue;
      LandmarkMeasurement m = reduce(reading, detection, map.meanHeight(), Vector2d::Zero());
      if (m.bearing || m.range) result.push_back(std::move(m));
    }
  return result;
}

bool reduceToHorizontal(RunningFixReading& fix, double landmark_height)
{
  if (fix.horizontal_range) return true;
  const double dz = landmark_height - fix.sensor_height;
  for (auto [range, std] : {std::pair(&fix.first_range, &fix.first_std), std::pair(&fix.second_range, &fix.second_std)})
  {
    const double horizontal2 = square(*range) - dz * dz;
    if (!(horizontal2 > 0)) return false;
    *std *= *range / std::sqrt(horizontal2);
    *range = std::sqrt(horizontal2);
  }
  fix.horizontal_range = true;
  return true;
}

std::vector<PoseMeasurement> poseMeasurements(std::span<const LandmarkMeasurement> measurements)
{
  std::vector<PoseMeasurement> result;
  for (const LandmarkMeasurement& m : measurements)
  {
    if (m.bearing)
      result.push_back({PoseMeasurement::Kind::bearing, m.position, *m.bearing, m.std_bearing, m.T_robot_sensor});
    if (m.range) result.push_back({PoseMeasurement::Kind::range, m.position, *m.range, m.std_range, m.T_robot_sensor});
    if (m.headings && m.headings->attitudes.front().weight >= kCertainAttitude)
      result.push_back({PoseMeasurement::Kind::heading, m.position, m.headings->attitudes.front().yaw,
                        m.headings->attitudes.front().std, m.T_robot_sensor});
  }
  return result;
}
}  // namespace mrpt_ext
