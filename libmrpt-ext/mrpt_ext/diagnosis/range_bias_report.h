#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/settings/ini_edit.h"

namespace mrpt_ext
{
/// What the ranges of a recording tell about its radios.
struct RadioFindings
{
  std::vector<std::string> lines;            ///< for people, one finding each
  std::vector<IniAssignment> configuration;  ///< what to set in a configuration of landmark-localization
};

/// Delays, scatter and outliers of radios, from moments at which several sensors of the robot range to named landmarks
/// (calibration/range_bias_calibration.h); never from the truth. Where there are too few such moments, a line says so
/// and there is nothing to set.
[[nodiscard]] RadioFindings examineRadios(const Recording& recording);
}  // namespace mrpt_ext
