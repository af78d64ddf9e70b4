#include "mrpt_ext/frames/scan_skew.h"

namespace mrpt_ext
{
void removeScanSkew(Reading& reading, const ScanSweep& sweep, const OdometryPath& odometry)
{
  if (!(sweep.duration > 0)) return;
  const Pose2 T_odometry_sensor = compose(odometry.at(reading.time), reading.T_robot_sensor);
  for (Detection& detection : reading.detections)
  {
    if (!detection.bearing) continue;
    const double time = reading.time - sweep.ageOf(*detection.bearing, reading.model.field_of_view);
    const Pose2 T_sensor_then = between(T_odometry_sensor, compose(odometry.at(time), reading.T_robot_sensor));
    Vector2d seen = rotation(T_sensor_then.phi + *detection.bearing) * Vector2d(detection.range.value_or(1), 0);
    if (detection.range)
    {
      seen += T_sensor_then.position();
      detection.range = seen.norm();
    }
    detection.bearing = std::atan2(seen.y(), seen.x());
  }
}
}  // namespace mrpt_ext
