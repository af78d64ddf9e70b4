#pragma once

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// A small room: a robot on a circle measures anonymous bearings (2 deg) to 12 landmarks twice a second, with
/// odometry at 5 Hz that drifts, and now and then a range and a running fix. Map and truth come with it.
[[nodiscard]] Recording walkThroughRoom(double seconds);
}  // namespace mrpt_ext
