#pragma once

#include <optional>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// What a detection shows.
struct DetectionMatch
{
  std::optional<std::size_t> landmark;  ///< number in the map
  bool none = false;  ///< no landmark is near; false without a landmark: several are, or the id is unknown
};

/// Of a detection by a robot at `robot`: the landmark with its id, or the only one within four standard deviations (and
/// the next one outside seven).
[[nodiscard]] DetectionMatch matchOf(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                                     const GaussianPose& robot);
}  // namespace mrpt_ext
