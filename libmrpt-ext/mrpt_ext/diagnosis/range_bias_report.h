#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/settings/ini_edit.h"

namespace mrpt_ext
{
/// Range biases of the radios of a recording.
struct RangeBiasReport
{
  std::vector<std::string> lines;            ///< for the reader, one finding each
  std::vector<IniAssignment> configuration;  ///< what to set in a configuration of landmark-localization
};

/// Biases, noise and outliers of radios, from epochs at which several sensors of the robot range to identified
/// landmarks (calibration/range_bias_calibration.h); never from the truth. With too few such epochs, a line states it
/// and there is nothing to set.
[[nodiscard]] RangeBiasReport reportRangeBiases(const Recording& recording);
}  // namespace mrpt_ext
