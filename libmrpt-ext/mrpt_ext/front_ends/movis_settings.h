#pragma once

#include <array>

#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/solvers/two_pole_pose.h"
#include "mrpt_ext/vision/omni_objects.h"

namespace mrpt_ext
{
/// The three cameras and the field, from the .ini and camera.json.
struct MovisSettings
{
  double mount_radius = 0;            ///< L [m] of paper 001, from the robot's middle to each mirror
  std::array<double, 3> mount_yaw{};  ///< [rad] by which the cameras are known to be turned
  std::array<OmniCameraSettings, 3> cameras;
  PoleField field;
};

/// The .ini wins over camera.json. Throws InputError naming what neither has.
[[nodiscard]] MovisSettings movisSettings(const Settings& settings, const CameraFile& camera);
}  // namespace mrpt_ext
