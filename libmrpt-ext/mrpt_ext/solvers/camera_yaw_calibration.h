#pragma once

#include <cstddef>
#include <span>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// One bearing that a camera measured to a landmark while the robot stood at a known pose.
struct CalibrationSighting
{
  Pose2 robot;              ///< world frame
  Vector2d landmark{0, 0};  ///< world frame
  double bearing = 0;       ///< [rad] in the camera's frame
  double std_bearing = 0;   ///< [rad] with the error of the places; 0: not known, all sightings are then believed
};

struct CameraYaw
{
  SolveStatus status = SolveStatus::too_few;
  double offset = 0;      ///< measured minus predicted [rad]: subtract from bearings, or add to the camera's yaw
  double std_offset = 0;  ///< of the mean, from the scatter [rad]; 0 with a single sighting
  double scatter = 0;     ///< standard deviation of one sighting about the mean [rad]
  double spread = 0;      ///< largest difference between two sightings, left out or not [rad]
  std::size_t used = 0;   ///< sightings that agree
};

/// How far a camera is turned against its nominal pose on the robot: circular mean of measured minus predicted bearing.
/// What paper 001's eq 8 should have been: its per-axis factors cannot express a turned camera, which is the likely
/// systematic error. One call per camera; several sightings of each landmark average the noise.
/// Sightings with a standard deviation must agree: of three and more the largest set that agrees with one of them is
/// taken, if it is more than half; of two both. One alone cannot be checked (`too_few`). Status: `none` when they do
/// not agree or point all around (wrong landmarks), `bad_input`, `too_few`.
[[nodiscard]] CameraYaw calibrateCameraYaw(std::span<const CalibrationSighting> sightings, const Pose2& T_robot_camera);
}  // namespace mrpt_ext
