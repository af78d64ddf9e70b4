#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "mrpt_ext/diagnosis/calibration_data.h"

namespace mrpt_ext
{
/// Share of outliers among the readings of a sensor.
struct OutlierShare
{
  std::size_t readings = 0;   ///< bearings or ranges that were counted
  std::size_t matched = 0;    ///< of these, with a landmark
  double share = 0, std = 0;  ///< in [0, 1], and its standard deviation
};

/// Of the bearings or the ranges of sensor number `sensor`, whichever are worse (they have one probability of clutter),
/// before pose number `end`: those with a misfit beyond kOutlierMisfit, and those of detections that no landmark is
/// near. Clutter comes at all times: blocks of time with significantly more outliers than most others are left out, for
/// there the trajectory was wrong. Nothing without a reading that has a landmark: that is no clutter but another map.
/// `misfits`: by reading of `data.problem`, those from `end` on are not used.
[[nodiscard]] OutlierShare outlierShare(const CalibrationData& data, const std::vector<double>& misfits,
                                        std::size_t sensor, std::size_t end = std::numeric_limits<std::size_t>::max());
}  // namespace mrpt_ext
