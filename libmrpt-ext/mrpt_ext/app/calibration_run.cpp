#include "mrpt_ext/app/calibration_run.h"

#include <algorithm>
#include <functional>
#include <ostream>

#include "mrpt_ext/app/calibrated_file.h"
#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/diagnosis/log_diagnosis.h"
#include "mrpt_ext/diagnosis/place_deviation.h"
#include "mrpt_ext/experiment/clock_check.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{

std::string whyImpossible(SolveStatus status, const std::vector<PoseEstimate>& trajectory)
{
  if (trajectory.empty())
    return "the filter never came to a single pose: check the map (order of x and y, metres) and where the sensors are "
           "on the robot, or set wider std_range_m, std_bearing_deg or [Bias] to start from";
  return status == SolveStatus::too_few ? "too few measurements while the pose was unique"
                                        : "the measurements do not determine the trajectory";
}

/// The data that the calibration rests on.
std::string headline(const LocalizationInput& input, const CalibrationData& data,
                     const std::vector<PoseEstimate>& trajectory)
{
  const auto frames = static_cast<double>(input.log.frames);
  const std::vector<CalibrationReading>& readings = data.problem.readings;
  const auto ranges = static_cast<std::size_t>(
      std::count_if(readings.begin(), readings.end(), std::mem_fn(&CalibrationReading::is_range)));
  std::string text = "data     " + readingsText(readings.size() - ranges, ranges) + " in " +
                     fixedText(input.context.duration_s, 1) + " s, where the pose was unique (" +
                     fixedText(100 * static_cast<double>(trajectory.size()) / frames, 0) + " % of the frames)";
  if (data.ambiguous > 0)
    text += "; " + std::to_string(data.ambiguous) + " detections with several landmarks near left out";
  if (data.repeated > 0)
    text += "; " + std::to_string(data.repeated) + " readings with the error of one shortly before left out";
  return text + "; the truth was not used";
}

std::vector<IniAssignment> linesToSet(std::vector<CalibrationFinding> findings, const CalibrationData& data,
                                      const SensorConfigs& sensors)
{
  std::erase_if(findings, [](const CalibrationFinding& finding) { return !finding.differs; });
  std::vector<IniAssignment> lines;
  for (const CalibrationFinding& finding : findings) lines.push_back(finding.line);
  for (const CalibrationFinding& finding : placeDeviations(findings, data, sensors)) lines.push_back(finding.line);
  return lines;
}
}  // namespace

int runCalibration(Settings settings, const CalibrationRequest& request, std::ostream& out)
{
  const std::string ini = request.calibrated.empty() ? "" : readFileToCalibrate(request.calibrated, request.initial);
  const bool is_new = !std::filesystem::exists(request.calibrated);
  if (settings.hasValue(kExperimentSection, "ground_truth_path_file"))
    settings.set(kExperimentSection, "ground_truth_path_file", "", "--diagnose");
  LocalizationInput input = loadLocalization(settings, request.window);
  checkClocks(input);
  const LogDiagnosis found = diagnoseLog(input);
  if (!request.quiet) out << headline(input, found.data, found.trajectory) << '\n';
  if (found.errors.status != SolveStatus::ok)
  {
    out << "calibration not possible: " << whyImpossible(found.errors.status, found.trajectory) << '\n';
    return kExitDone;
  }
  const std::vector<IniAssignment> lines = linesToSet(found.findings, found.data, input.config.frames.sensors);
  if (request.quiet)
  {
    for (const IniAssignment& line : lines)
      out << "set [" << line.section << "] " << line.key << " = " << line.value << '\n';
  }
  else
  {
    for (const std::string& line : findingsTable(found.findings)) out << line << '\n';
    for (const std::string& line : landmarkLines(found.errors, found.data, input.context.map)) out << line << '\n';
  }
  if (request.calibrated.empty()) return kExitDone;
  if (lines.empty())
  {
    if (is_new && !request.quiet) out << "nothing to set: " << request.calibrated.string() << " is not needed\n";
    return kExitDone;
  }
  writeFileAtomically(request.calibrated, withValues(ini, lines));
  if (!request.quiet)
    out << "wrote " << request.calibrated.string()
        << (is_new ? ": the built-in configuration with these lines\n" : "\n");
  return kExitDone;
}
}  // namespace mrpt_ext
