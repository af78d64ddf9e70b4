#include "mrpt_ext/diagnosis/log_diagnosis.h"

#include "mrpt_ext/diagnosis/calibration_trajectory.h"
#include "mrpt_ext/diagnosis/noise_findings.h"

namespace mrpt_ext
{
LogDiagnosis diagnoseLog(const LocalizationInput& input)
{
  LogDiagnosis diagnosis;
  diagnosis.trajectory = calibrationTrajectory(input, input.config.seed);
  diagnosis.data = collectCalibrationData(input, diagnosis.trajectory);
  const CalibrationData& data = diagnosis.data;
  diagnosis.errors = calibrate(data.problem, calibrationUnknowns(input, data));
  if (diagnosis.errors.status != SolveStatus::ok) return diagnosis;
  diagnosis.findings = calibrationFindings(diagnosis.errors, data.sensors, input.config);
  for (CalibrationFinding& finding : noiseFindings(diagnosis.errors, data, input.config))
    diagnosis.findings.push_back(std::move(finding));
  return diagnosis;
}
}  // namespace mrpt_ext
