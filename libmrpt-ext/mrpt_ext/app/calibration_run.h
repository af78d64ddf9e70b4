#pragma once

#include <filesystem>
#include <iosfwd>

#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
struct ExaminationRequest
{
  LogWindow window;
  std::filesystem::path calibrated;  ///< configuration to write the lines into; empty: none
  bool quiet = false;                ///< tell nothing but the lines to set
};

/// The data doctor: what the log says about the systematic errors of its sensors and its odometry, from the log and the
/// map alone, and which lines of the configuration follow. The filter runs once as configured, then its track and all
/// errors are adjusted together (calibration/self_calibration.h). The truth is never used. Returns the exit code: done,
/// also when nothing can be told.
int runExamination(Settings settings, const ExaminationRequest& request, std::ostream& out);
}  // namespace mrpt_ext
