#pragma once

#include <array>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// What errs in odometry by itself: wheels slip along the way while a gyro holds the heading, or the heading wanders
/// while the distance is right. A factor on both alike would state one of them wrongly.
enum MotionNoise : std::size_t
{
  position_noise,
  heading_noise,  ///< also displaces the end of a motion
  motion_noises
};
template <typename Value>
using PerMotionNoise = std::array<Value, motion_noises>;

/// Covariance of an increment (x, y, phi) [m^2, m rad, rad^2] whose noises have `scatter` times the declared standard
/// deviations; `declared`: the covariances by each.
[[nodiscard]] inline Matrix3d scattered(const PerMotionNoise<Matrix3d>& declared,
                                        const PerMotionNoise<double>& scatter = {1, 1})
{
  return square(scatter[position_noise]) * declared[position_noise] +
         square(scatter[heading_noise]) * declared[heading_noise];
}
}  // namespace mrpt_ext
