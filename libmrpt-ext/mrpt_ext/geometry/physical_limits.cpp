#include "mrpt_ext/geometry/physical_limits.h"

#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
namespace
{
std::string impossible(const char* what, double value, const char* unit, double limit)
{
  return formatted("%s %g %s, expected at most %g %s either way", what, value, unit, limit, unit);
}

std::string whyNoPosition(const char* what, double x, double y, double z = 0)
{
  for (const double coordinate : {x, y, z})
    if (!isCoordinate(coordinate)) return impossible(what, coordinate, "m", kLargestCoordinate);
  return {};
}

std::string whyImpossibleValue(const OdometryRecord& odometry)
{
  return whyNoPosition("odometry at", odometry.pose.x, odometry.pose.y);
}

std::string whyImpossibleValue(const Reading& reading)
{
  return whyNoPosition("sensor on the robot at", reading.T_robot_sensor.x, reading.T_robot_sensor.y,
                       reading.sensor_height);
}

std::string whyImpossibleValue(const RunningFixReading& fix)
{
  std::string sensor =
      whyNoPosition("sensor on the robot at", fix.T_robot_sensor.x, fix.T_robot_sensor.y, fix.sensor_height);
  if (!sensor.empty()) return sensor;
  if (!isTime(fix.first_time)) return impossible("time of the first range", fix.first_time, "s", kLargestTime);
  return whyNoPosition("displacement of", fix.displacement.x, fix.displacement.y);
}

std::string whyImpossibleValue(const CompassRecord&) { return {}; }

std::string whyImpossibleValue(const RangeScan& scan)
{
  return whyNoPosition("sensor on the robot at", scan.T_robot_sensor.x, scan.T_robot_sensor.y, scan.sensor_height);
}
}  // namespace

std::string whyImpossible(const Record& record)
{
  if (!isTime(timeOf(record))) return impossible("time", timeOf(record), "s", kLargestTime);
  return std::visit([](const auto& r) { return whyImpossibleValue(r); }, record);
}
}  // namespace mrpt_ext
