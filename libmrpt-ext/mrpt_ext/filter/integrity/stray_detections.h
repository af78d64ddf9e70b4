#pragma once

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
/// Anonymous detections with a bearing, by one sensor, of what is not in the map, seen from the pose under test.
///
/// People, other robots and shiny things stay where they are, as landmarks do. With a fixed probability of clutter, and
/// clutter that is spread evenly, each detection of one would speak against the right pose as loudly as against a wrong
/// one. So what is not in the map is expected as the null model expects it, and its share is what was found so far,
/// with the declared one as the prior, worth the detections among which it expects one.
class StrayDetections
{
 public:
  /// What counts of the log-likelihood ratio of a detection that shows something in the map or is clutter.
  [[nodiscard]] double counted(double log_ratio, const SensorModel& model)
  {
    const double declared = boundedClutter(model.clutter_probability);
    const double share = (1 + strays_) / (1 / declared + detections_);
    const double ratio = std::exp(std::min(log_ratio, 100.0)), both = share + (1 - share) * ratio;
    detections_ += 1;
    strays_ += share / both;
    return std::log(both);
  }

 private:
  double detections_ = 0, strays_ = 0;  // expected number
};
}  // namespace mrpt_ext
