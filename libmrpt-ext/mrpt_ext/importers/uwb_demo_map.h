#pragma once

#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// The three radio beacons of MRPT's demo log uwb_ro-localization_demo.rawlog, from the configuration file that comes
/// with it (MRPT 2.5.8, ro-localization/UWB_localization_demo.ini, beacon_00n_X/Y/Z) [m].
[[nodiscard]] inline LandmarkTable uwbDemoMap()
{
  return LandmarkTable({{1, {0.21, -0.55, 1.94}, "beacon", {0, 0}},
                        {2, {6.71, -0.33, 1.04}, "beacon", {0, 0}},
                        {3, {6.7023, 4.3185, 1.33}, "beacon", {0, 0}}});
}

/// Where that demo's robot starts, from the same file ([OdometryEstimation]); its truth file is relative to it.
inline constexpr Pose2 kUwbDemoStart{2, 4, 0};
}  // namespace mrpt_ext
