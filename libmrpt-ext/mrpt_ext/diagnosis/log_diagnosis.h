#pragma once

#include <vector>

#include "mrpt_ext/diagnosis/calibration_report.h"

namespace mrpt_ext
{
/// What `--diagnose` finds in a log.
struct LogDiagnosis
{
  std::vector<PoseEstimate> trajectory;      ///< the estimates that it rests on
  CalibrationData data;                      ///< the readings along them
  CalibrationResult errors;                  ///< not `ok`: no findings
  std::vector<CalibrationFinding> findings;  ///< errors, then noise
};

/// The filter runs as configured (likelierTrajectory()); then its trajectory and all errors are adjusted together
/// (calibration/self_calibration.h). The truth is never used.
[[nodiscard]] LogDiagnosis diagnoseLog(const LocalizationInput& input);
}  // namespace mrpt_ext
