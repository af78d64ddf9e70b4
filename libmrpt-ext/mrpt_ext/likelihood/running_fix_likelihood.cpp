#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
/// Covariance of the sensor's first position in the frame of the second pose, from that of the displacement (x, y, phi)
/// in the frame of the first pose.
Matrix2d firstPositionCovariance(const RunningFixReading& fix, const Vector2d& first)
{
  const double c = std::cos(fix.displacement.phi), s = std::sin(fix.displacement.phi);
  Eigen::Matrix<double, 2, 3> J;  // d first / d displacement
  J << -c, -s, first.y(), s, -c, -first.x();
  return J * fix.displacement_covariance * J.transpose();
}

Reading withoutDetections(const RunningFixReading& fix)
{
  Reading reading;
  reading.sensor = fix.sensor;
  reading.sensor_height = fix.sensor_height;
  reading.horizontal_range = fix.horizontal_range;
  reading.model = fix.model;
  reading.model.detection_probability.reset();  // it reports one landmark by design, others are not missed
  return reading;
}
}  // namespace

std::vector<Reading> asReadings(const RunningFixReading& fix)
{
  Reading second = withoutDetections(fix);
  second.time = fix.time;
  second.T_robot_sensor = fix.T_robot_sensor;
  second.detections = {{.id = fix.id,
                        .bearing = fix.second_bearing,
                        .range = fix.second_range,
                        .std_bearing = fix.second_bearing_std,
                        .std_range = fix.second_std}};

  Reading first = withoutDetections(fix);
  first.time = fix.first_time;
  first.T_robot_sensor = compose(inverse(fix.displacement), fix.T_robot_sensor);
  first.sensor_position_covariance = firstPositionCovariance(fix, first.T_robot_sensor.position());
  first.detections = {{.id = fix.id, .range = fix.first_range, .std_range = fix.first_std}};
  return {first, second};
}

std::vector<Reading> scoredReadings(const Frame& frame)
{
  std::vector<Reading> readings = frame.readings;
  for (const RunningFixReading& fix : frame.fixes)
    if (!fix.ranges_logged_too)
      for (Reading& reading : asReadings(fix)) readings.push_back(std::move(reading));
  return readings;
}
}  // namespace mrpt_ext
