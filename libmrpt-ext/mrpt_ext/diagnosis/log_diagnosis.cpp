#include "mrpt_ext/diagnosis/log_diagnosis.h"

#include <optional>
#include <set>
#include <utility>

#include "mrpt_ext/diagnosis/calibration_trajectory.h"
#include "mrpt_ext/diagnosis/choice_part.h"
#include "mrpt_ext/diagnosis/noise_findings.h"
#include "mrpt_ext/diagnosis/partial_calibration.h"
#include "mrpt_ext/diagnosis/repeated_readings.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTellsApart = 3;  // standard deviations of what landmarks share, and of what turns in place differ by

/// All errors together, as `found` if they are estimated already. Where the landmarks of a sensor differ too much to
/// tell what they share, nothing is taken from their own offsets for that. Turns in place that hardly differ from
/// others tell the scale of all.
CalibrationResult calibrateLog(const CalibrationData& data, const std::vector<CalibrationUnknown>& unknowns,
                               std::optional<CalibrationResult> found)
{
  const CalibrationResult all = found ? std::move(*found) : calibrate(data.problem, unknowns);
  std::set<std::size_t> of_landmarks, shares;  // sensors
  for (const ParameterEstimate& error : all.errors)
  {
    if (isOfLandmark(error.unknown.parameter)) of_landmarks.insert(error.unknown.sensor);
    if (isOfAllRanges(error.unknown.parameter) && strengthOf(error) > kTellsApart) shares.insert(error.unknown.sensor);
  }
  const auto is_untold = [&](const CalibrationUnknown& unknown)
  {
    return isOfAllRanges(unknown.parameter) && of_landmarks.contains(unknown.sensor) &&
           !shares.contains(unknown.sensor);
  };
  if (all.status != SolveStatus::ok) return all;
  std::vector<std::size_t> told = withToldRegimes(unknowns, all, kTellsApart);
  std::erase_if(told, [&](std::size_t k) { return is_untold(unknowns[k]); });
  if (told.size() == unknowns.size()) return all;
  return calibrateSome(data.problem, unknowns, told, all);
}
}  // namespace

LogDiagnosis diagnoseLog(const LocalizationInput& input)
{
  LogDiagnosis diagnosis;
  diagnosis.trajectory = calibrationTrajectory(input, input.config.seed);
  diagnosis.data = collectCalibrationData(input, diagnosis.trajectory);
  if (const auto other = withLikelierDepths(input, diagnosis.data))
  {
    std::vector<PoseEstimate> trajectory = calibrationTrajectory(*other, other->config.seed);
    if (lookAgain(*other, trajectory, diagnosis.data)) diagnosis.trajectory = std::move(trajectory);
  }
  const CalibrationData& data = diagnosis.data;
  const std::vector<CalibrationUnknown> unknowns = calibrationUnknowns(input, data);
  std::optional<CalibrationResult> found = leaveOutRepeated(diagnosis.data, unknowns);
  diagnosis.errors = calibrateLog(data, unknowns, std::move(found));
  if (diagnosis.errors.status != SolveStatus::ok) return diagnosis;
  diagnosis.findings = calibrationFindings(diagnosis.errors, data, input.config);
  for (CalibrationFinding& finding : depthFindings(data)) diagnosis.findings.push_back(std::move(finding));
  for (CalibrationFinding& finding : noiseFindings(diagnosis.errors, data, input.config))
    diagnosis.findings.push_back(std::move(finding));
  return diagnosis;
}
}  // namespace mrpt_ext
