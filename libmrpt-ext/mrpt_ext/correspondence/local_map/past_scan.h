#pragma once

#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// What one sensor saw from a scan that the robot has since left. Deviations are those of the sensor alone; what
/// odometry adds is shared by all that was seen from there.
struct PastScan
{
  Scan scan;  ///< T_robot_sensor: the sensor's scan then, in the robot frame of now
  Matrix3d odometry_covariance =
      Matrix3d::Zero();  ///< of the way since, as an error of the robot's pose now (robot axes)
};
}  // namespace mrpt_ext
