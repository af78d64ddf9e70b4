#pragma once

#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/calibration/predictive_likelihood.h"

namespace mrpt_ext
{
/// Whether the ranges of a sensor are depths along an axis: cameras measure either, and which one is seldom
/// stated. Sensors that see to the side cannot measure depths; theirs are not in question.
struct DepthHypothesis
{
  std::size_t sensor = 0;
  bool configured = false, likelier = false;  ///< likelier: as configured, unless the other is told
  bool told = false;                          ///< which one it is: by two standard deviations of the gain
  PredictiveGain gain;                        ///< of what is not configured over what is
  [[nodiscard]] bool differs() const { return likelier != configured; }
};

/// True for a sensor all of whose bearings are within 72 degrees of ahead, as a camera's, and of the axis that depths
/// are along.
[[nodiscard]] bool looksAhead(const CalibrationProblem& problem, std::size_t sensor);

/// One per sensor that measures bearings and ranges in a narrow field of view. `problem`: ranges by `is_depth`, what is
/// configured for each sensor; they are replaced where the other hypothesis predicts the second half of the recording
/// significantly better. With either, `unknowns` and noise are those that the first half tells with it: a wrong scale
/// would look like the wrong kind of range. `model`: what is assumed of outliers.
[[nodiscard]] std::vector<DepthHypothesis> chooseDepths(CalibrationProblem& problem, const std::vector<bool>& is_depth,
                                                        const std::vector<CalibrationUnknown>& unknowns,
                                                        const RecordingModel& model);
}  // namespace mrpt_ext
