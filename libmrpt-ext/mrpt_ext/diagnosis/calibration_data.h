#pragma once

#include <set>
#include <string>
#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/calibration/independent_readings.h"
#include "mrpt_ext/diagnosis/depth_hypothesis.h"
#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// A bearing or a range of a detection that no landmark is near.
struct UnmatchedReading
{
  std::size_t pose = 0;    ///< number of the pose of its stamp
  std::size_t sensor = 0;  ///< number of the sensor
  bool is_range = false;   ///< else a bearing
};

/// A log as a problem of self-calibration (calibration/self_calibration.h).
struct CalibrationData
{
  CalibrationProblem problem;
  std::vector<std::string> sensors;         ///< labels, by number
  std::vector<int> ids;                     ///< of the landmarks, by number in the map
  std::vector<bool> identified;             ///< by sensor: all its readings carry the id of their landmark
  std::vector<UnmatchedReading> unmatched;  ///< ordered by pose
  std::vector<DepthHypothesis> depths;      ///< of the sensors for which this is a question, ranges as is likelier
  std::size_t ambiguous = 0;                ///< detections left out because several landmarks are near
  CorrelationTimes correlation_times;       ///< [s] of the errors of readings (diagnosis/repeated_readings.h)
  std::size_t repeated = 0;                 ///< readings left out because one shortly before has their error
  bool compass = false;                     ///< a compass measures the heading
  bool commanded = false;                   ///< odometry is integrated from commands
  bool verified = false;                    ///< at least one estimate of the trajectory was `ok`
};

/// Labels of the sensors that measure bearings.
[[nodiscard]] std::set<std::string> sensorsWithBearings(const CalibrationData& data);

/// One pose per stamp near an estimate of `trajectory`, and more in between where odometry bridges a gap, for the first
/// 100 000 readings. Anonymous detections are associated with the only landmark within their gate; where most
/// have several, which stand close together, with a mixture of these. What is configured as the range and was the
/// depth, or the other way round, is converted. Never uses the truth.
[[nodiscard]] CalibrationData collectCalibrationData(const LocalizationInput& input,
                                                     const std::vector<PoseEstimate>& trajectory);

/// The same input with ranges of the likelier kind; nothing where all are as configured.
[[nodiscard]] std::optional<LocalizationInput> withLikelierDepths(const LocalizationInput& input,
                                                                  const CalibrationData& data);

/// Replaces `data` by what is collected from `likelier`, withLikelierDepths(), and its trajectory: what was associated
/// and tracked with ranges of the other kind. False, and nothing done, where the kind is in doubt then.
bool lookAgain(const LocalizationInput& likelier, const std::vector<PoseEstimate>& trajectory, CalibrationData& data);

/// The errors that this log could tell. An offset per landmark for identified ranges without bearings: radios have a
/// delay of their own; of up to twelve also its place in the map. A scale of bearings for sensors that look ahead, an
/// axis of depths for those that measure depths.
[[nodiscard]] std::vector<CalibrationUnknown> calibrationUnknowns(const LocalizationInput& input,
                                                                  const CalibrationData& data);
}  // namespace mrpt_ext
