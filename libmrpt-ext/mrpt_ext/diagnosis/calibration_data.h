#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// A log as the solver of systematic errors takes it (calibration/self_calibration.h).
struct CalibrationData
{
  CalibrationProblem way;
  std::vector<std::string> sensors;    ///< labels, by number
  std::vector<std::size_t> landmarks;  ///< of the map, by reading
  std::size_t anonymous = 0;           ///< detections left out because several landmarks, or none, may be meant
};

/// Where a method was sure to be, in order of time: the particle filter, or for independent frames the closed forms.
/// Estimates whose verdict is not `ok` or that have no heading are left out.
[[nodiscard]] std::vector<PoseEstimate> confidentTrajectory(const LocalizationInput& input, std::uint64_t seed);

/// One pose per stamp at which a method was sure (`track`), and more in between where odometry bridges a pause. `input`
/// must be cut into frames of one stamp each (frame_window_s = 0); `window` [s] is what the track was made with.
/// Detections without a name are given that of the only landmark that is near enough.
[[nodiscard]] CalibrationData examinedWay(const LocalizationInput& input, const std::vector<PoseEstimate>& track,
                                          double window);
}  // namespace mrpt_ext
