#include "mrpt_ext/app/calibration_run.h"

#include <ostream>
#include <set>

#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/diagnosis/calibration_report.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_file.h"

namespace mrpt_ext
{
namespace
{
const std::string kExperiment = "LocalizationExperiment";

/// What there is to be asked of this log.
std::vector<ErrorTerm> termsOf(const LocalizationInput& input, const CalibrationData& examined)
{
  const bool moving = !input.config.frames.independent && !examined.problem.odometry.empty() &&
                      input.config.filter.motion.type != MotionType::random_walk;
  std::set<std::size_t> bearings, ranges;
  for (const CalibrationReading& r : examined.problem.readings) (r.is_range ? ranges : bearings).insert(r.sensor);
  std::vector<ErrorTerm> terms;
  if (moving)
    terms = {
        {CalibrationParameter::distance_scale}, {CalibrationParameter::rotation_scale}, {CalibrationParameter::veer}};
  for (std::size_t s = 0; s < examined.sensors.size(); ++s)
  {
    if (moving && (bearings.count(s) > 0 || ranges.count(s) > 0)) terms.push_back({CalibrationParameter::delay, s});
    if (bearings.count(s) > 0) terms.push_back({CalibrationParameter::bearing_offset, s});
    if (ranges.count(s) == 0) continue;
    terms.push_back({CalibrationParameter::range_offset, s});
    terms.push_back({CalibrationParameter::range_scale, s});
  }
  return terms;
}

std::string whyNothing(SolveStatus status, const std::vector<PoseEstimate>& track)
{
  if (track.empty())
    return "the filter was never sure of a place: give it wider std_range_m, std_bearing_deg or [Bias] to start from";
  return status == SolveStatus::too_few ? "too few readings were made where the filter was sure of its place"
                                        : "the readings leave the way undetermined";
}

/// How much of the log the filter knew its place in.
std::string headline(const LocalizationInput& input, const CalibrationData& examined,
                     const std::vector<PoseEstimate>& track)
{
  const auto frames = static_cast<double>(input.log.frames);
  std::string text = "examined " + std::to_string(examined.problem.readings.size()) + " bearings and ranges in " +
                     fixedText(input.context.duration_s, 1) + " s, where the place was sure (" +
                     fixedText(100 * static_cast<double>(track.size()) / frames, 0) + " % of the frames)";
  if (examined.anonymous > 0)
    text += "; " + std::to_string(examined.anonymous) + " detections whose landmark is unclear were left out";
  return text + "; the truth was not used";
}

std::vector<IniAssignment> linesToSet(const std::vector<CalibrationFinding>& findings)
{
  std::vector<IniAssignment> lines;
  for (const CalibrationFinding& finding : findings)
    if (finding.differs) lines.push_back(finding.line);
  return lines;
}
}  // namespace

int runExamination(Settings settings, const ExaminationRequest& request, std::ostream& out)
{
  const std::string text = request.calibrated.empty() ? "" : readTextFile(request.calibrated);
  if (settings.hasValue(kExperiment, "ground_truth_path_file"))
    settings.set(kExperiment, "ground_truth_path_file", "", "--examine");
  const LocalizationInput input = loadLocalization(settings, request.window);
  settings.set(kExperiment, "frame_window_s", "0", "--examine");
  const LocalizationInput by_stamp = loadLocalization(settings, request.window);

  const auto seed = static_cast<std::uint64_t>(settings.integer(kExperiment, "random_seed"));
  const std::vector<PoseEstimate> track = confidentTrajectory(input, seed);
  const CalibrationData examined = collectCalibrationData(by_stamp, track, input.config.frames.window);
  const RecordingErrors errors = calibrate(examined.problem, termsOf(input, examined));
  if (!request.quiet) out << headline(input, examined, track) << '\n';
  if (errors.status != SolveStatus::ok)
  {
    out << "nothing can be told: " << whyNothing(errors.status, track) << '\n';
    return kExitDone;
  }
  std::vector<CalibrationFinding> findings = calibrationFindings(errors, examined.sensors, input.config);
  for (CalibrationFinding& finding : noiseFindings(errors, examined, input.config))
    findings.push_back(std::move(finding));
  const std::vector<IniAssignment> lines = linesToSet(findings);
  if (request.quiet)
  {
    for (const IniAssignment& line : lines)
      out << "set [" << line.section << "] " << line.key << " = " << line.value << '\n';
  }
  else
  {
    for (const std::string& line : findingsTable(findings)) out << line << '\n';
    if (!examined.problem.odometry.empty())
      out << "odometry errs " << fixedText(errors.way_scatter, 1) << " times as much as [MotionModel] declares\n";
    for (const std::string& line : landmarkLines(errors, examined, input.context.map)) out << line << '\n';
  }
  if (request.calibrated.empty() || lines.empty()) return kExitDone;
  writeFileAtomically(request.calibrated, withValues(text, lines));
  if (!request.quiet) out << "wrote " << request.calibrated.string() << '\n';
  return kExitDone;
}
}  // namespace mrpt_ext
