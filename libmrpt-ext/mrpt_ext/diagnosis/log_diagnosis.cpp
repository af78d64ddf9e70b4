#include "mrpt_ext/diagnosis/log_diagnosis.h"

#include <cmath>
#include <set>

#include "mrpt_ext/diagnosis/calibration_trajectory.h"
#include "mrpt_ext/diagnosis/noise_findings.h"

namespace mrpt_ext
{
namespace
{
constexpr double kShared = 3;  // standard deviations of what the landmarks of a sensor share

/// All errors together. Where the landmarks of a sensor differ too much to tell what they share, nothing is taken from
/// their own offsets for that.
CalibrationResult calibrateLog(const CalibrationData& data, const std::vector<CalibrationUnknown>& unknowns)
{
  CalibrationResult all = calibrate(data.problem, unknowns);
  std::set<std::size_t> of_landmarks, shares;  // sensors
  for (const ParameterEstimate& error : all.errors)
  {
    if (error.unknown.parameter == CalibrationParameter::landmark_offset) of_landmarks.insert(error.unknown.sensor);
    if (isOfAllRanges(error.unknown.parameter) && std::abs(error.value) > kShared * error.std)
      shares.insert(error.unknown.sensor);
  }
  const auto is_untold = [&](const CalibrationUnknown& unknown)
  {
    return isOfAllRanges(unknown.parameter) && of_landmarks.contains(unknown.sensor) &&
           !shares.contains(unknown.sensor);
  };
  std::vector<CalibrationUnknown> told = unknowns;
  std::erase_if(told, is_untold);
  if (all.status != SolveStatus::ok || told.size() == unknowns.size()) return all;
  CalibrationResult result = calibrate(data.problem, told);
  if (result.status != SolveStatus::ok) return all;
  std::vector<ParameterEstimate> errors;
  std::size_t next = 0;
  for (const ParameterEstimate& error : all.errors)
    errors.push_back(is_untold(error.unknown) ? error : result.errors[next++]);
  result.errors = std::move(errors);
  return result;
}
}  // namespace

LogDiagnosis diagnoseLog(const LocalizationInput& input)
{
  LogDiagnosis diagnosis;
  diagnosis.trajectory = calibrationTrajectory(input, input.config.seed);
  diagnosis.data = collectCalibrationData(input, diagnosis.trajectory);
  const CalibrationData& data = diagnosis.data;
  diagnosis.errors = calibrateLog(data, calibrationUnknowns(input, data));
  if (diagnosis.errors.status != SolveStatus::ok) return diagnosis;
  diagnosis.findings = calibrationFindings(diagnosis.errors, data, input.config);
  for (CalibrationFinding& finding : noiseFindings(diagnosis.errors, data, input.config))
    diagnosis.findings.push_back(std::move(finding));
  return diagnosis;
}
}  // namespace mrpt_ext
