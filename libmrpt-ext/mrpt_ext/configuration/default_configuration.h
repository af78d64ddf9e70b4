#pragma once

#include <string_view>

namespace mrpt_ext
{
/// The name of the configuration that runs without an .ini, in messages and reports.
inline constexpr std::string_view kDefaultConfigurationName = "built-in configuration";

/// Its text: an unknown start in the bounding box of the map, the identities and standard deviations of the log, the
/// odometry of an ordinary wheeled robot; auto_calibrate finds what differs. Files come from the command line.
[[nodiscard]] std::string_view defaultConfiguration();
}  // namespace mrpt_ext
