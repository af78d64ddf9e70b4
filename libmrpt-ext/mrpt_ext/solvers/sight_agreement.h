#pragma once

#include <vector>

#include "mrpt_ext/solvers/omni_stereo.h"

namespace mrpt_ext
{
/// A line of sight to an object, and how far away its size says that it is.
struct RangedSight
{
  SightRay ray;
  double distance = 0;  ///< [m] from the ray's origin, rough
};

/// Which lines of sight to one object another one confirms (epipolar constraint with a rough depth): seen from the
/// other place, the point that one of them gives is in the direction of the other one, but for `mounting` [rad] by
/// which cameras may be turned, three standard deviations of the rays, and half of the parallax, since distances are
/// rough. Of two that contradict each other neither is confirmed; one alone has nobody to contradict it and is.
[[nodiscard]] std::vector<bool> confirmedSights(const std::vector<RangedSight>& sights, double mounting);
}  // namespace mrpt_ext
