#pragma once

#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// A scan of the recent past. Its standard deviations are those of the sensor alone; the error of odometry since
/// then is common to all its detections.
struct PastScan
{
  Scan scan;  ///< T_robot_sensor: pose of the sensor then, in the present robot frame
  /// Of the motion since then, as an error of the present robot pose (robot axes).
  Matrix3d odometry_covariance = Matrix3d::Zero();
};
}  // namespace mrpt_ext
