#pragma once

#include <filesystem>
#include <iosfwd>
#include <string_view>

#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
struct CalibrationRequest
{
  LogWindow window;
  std::filesystem::path calibrated;  ///< configuration to write the lines into; empty: none
  std::string_view initial;          ///< what it begins as if it does not exist; empty: it has to
  bool quiet = false;                ///< print the lines to set and nothing else
};

/// Estimates the systematic errors of sensors and odometry from the log and the map alone, and prints the configuration
/// lines that follow. The filter runs as configured; then its trajectory and all errors are adjusted together
/// (calibration/self_calibration.h). The truth is never used. Returns the exit code: done, also when calibration is not
/// possible.
int runCalibration(Settings settings, const CalibrationRequest& request, std::ostream& out);
}  // namespace mrpt_ext
