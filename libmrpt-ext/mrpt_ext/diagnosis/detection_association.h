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

/// One of several landmarks that stand close together, whichever it is.
struct LandmarkMixture
{
  std::size_t likeliest = 0;              ///< number in the map
  Vector2d mean{0, 0};                    ///< [m], world frame
  double std_bearing = 0, std_range = 0;  ///< [rad], [m] of the detection, with what the landmarks differ by
};

/// Of an anonymous detection with a bearing and a range, which show about where the landmark is: those within four
/// standard deviations by their likelihoods, matched by mean and variance.
[[nodiscard]] std::optional<LandmarkMixture> mixtureOf(const Detection& detection, const Reading& reading,
                                                       const LandmarkTable& map, const GaussianPose& robot);
}  // namespace mrpt_ext
