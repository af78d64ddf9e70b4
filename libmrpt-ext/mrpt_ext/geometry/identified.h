#pragma once

#include <algorithm>

#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// True when some detection of the frame tells which landmark it shows.
[[nodiscard]] inline bool hasIdentified(const Frame& frame)
{
  const auto is_identified = [](const Detection& d) { return d.id != kNoId; };
  return std::any_of(frame.readings.begin(), frame.readings.end(),
                     [&](const Reading& reading)
                     { return std::any_of(reading.detections.begin(), reading.detections.end(), is_identified); });
}
}  // namespace mrpt_ext
