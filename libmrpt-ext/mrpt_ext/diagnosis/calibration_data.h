#pragma once

#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// A log as a problem of self-calibration (calibration/self_calibration.h).
struct CalibrationData
{
  CalibrationProblem problem;
  std::vector<std::string> sensors;              ///< labels, by number
  std::vector<std::size_t> landmarks;            ///< of the map, by reading
  std::map<std::string, std::size_t> unmatched;  ///< detections left out because no landmark is near, by sensor
  std::size_t anonymous = 0;                     ///< ... because several are
};

/// An estimate that calibration may rest on: `ok`, and with a heading where it is observable.
[[nodiscard]] bool isConfident(const PoseEstimate& estimate, const LocalizationConfig& config);

/// The confident estimates in order of time: those of the particle filter, or for independent frames of the closed
/// forms.
[[nodiscard]] std::vector<PoseEstimate> confidentTrajectory(const LocalizationInput& input, std::uint64_t seed);

/// One pose per stamp near an estimate of `trajectory`, and more in between where odometry bridges a gap, for the first
/// 100 000 readings. Anonymous detections are associated with the only landmark within their gate. Never uses the
/// truth.
[[nodiscard]] CalibrationData collectCalibrationData(const LocalizationInput& input,
                                                     const std::vector<PoseEstimate>& trajectory);

/// The errors that this log could tell.
[[nodiscard]] std::vector<CalibrationUnknown> calibrationUnknowns(const LocalizationInput& input,
                                                                  const CalibrationData& data);
}  // namespace mrpt_ext
