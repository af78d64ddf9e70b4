#pragma once

#include <array>
#include <nlohmann/json.hpp>

#include "mrpt_ext/settings/settings.h"
#include "mrpt_ext/solvers/two_pole_pose.h"
#include "mrpt_ext/vision/omni_objects.h"

namespace mrpt_ext
{
/// The three cameras and the field, as the .ini and camera.json tell them.
struct MovisSettings
{
  double mount_radius = 0;            ///< L [m] of paper 001, from the robot's middle to each mirror
  std::array<double, 3> mount_yaw{};  ///< [rad] by which the cameras are known to be turned
  std::array<OmniCameraSettings, 3> cameras;
  PoleField field;
};

/// The .ini wins over camera.json. Throws InputError naming what neither tells.
[[nodiscard]] MovisSettings movisSettings(const Settings& settings, const nlohmann::json& camera);
}  // namespace mrpt_ext
