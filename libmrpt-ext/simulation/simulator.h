#pragma once

#include <functional>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/simulation/scenario.h"

namespace mrpt_ext
{
/// Plays a scenario: log, map and truth (sampled at truth_rate_hz, and at the end). Same scenario, same result.
/// Map, path, odometry, every object and every sensor draw from random streams of their own, so that changing one
/// leaves the others as they were. `progress` is told the share done, in [0, 1]. Throws InputError (configuration) for
/// a scenario that cannot be played.
[[nodiscard]] Recording simulate(const Scenario& scenario, const std::function<void(double)>& progress = {});
}  // namespace mrpt_ext
