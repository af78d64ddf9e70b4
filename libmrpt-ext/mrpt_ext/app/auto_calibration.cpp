#include "mrpt_ext/app/auto_calibration.h"

#include <algorithm>
#include <optional>

#include "mrpt_ext/app/progress_line.h"
#include "mrpt_ext/diagnosis/adopted_findings.h"
#include "mrpt_ext/diagnosis/calibration_trajectory.h"
#include "mrpt_ext/diagnosis/repeated_readings.h"
#include "mrpt_ext/diagnosis/uncertain_odometry.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/experiment/trial_runner.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLeastDuration = 60;  // [s]
constexpr double kMostlyOk = 0.5;      // share of the frames
constexpr double kClearly = 0.02;      // more of the frames
constexpr const char* kOrigin = "auto_calibrate";
const std::string kFilterName = "particle_filter";

/// The passes before the run.
struct FirstPass
{
  std::vector<PoseEstimate> trajectory;  // of the likelier one
  CalibrationRow row;                    // of the one as configured
};

FirstPass firstPass(const LocalizationInput& input, bool show_progress, const std::string& name = "first pass")
{
  std::optional<CalibrationRow> row;
  const auto pass = [&](LocalizationConfig config)
  {
    config.methods = {kFilterName};
    const MethodFactory methods(config, input.context.map, input.log.available);
    ProgressLine line(show_progress, row ? name + ", scale of ranges estimated" : name);
    const std::atomic<bool> never{false};  // a signal ends the program: there is nothing yet to keep
    const auto progress = [&](double share) { line.show(share); };
    const TrialOutcome outcome = runTrial({methods, input, never, progress, {}}, config.seed, 0);
    CalibrationTrajectory trajectory(config);
    for (const PoseEstimate& point : outcome.record.methods.front().points) trajectory.add(point);
    if (row) return trajectory;
    const RunScore score = scoreRun(input.context, outcome.record, config.limits);
    row = {.verdict = score.verdict,
           .shares = score.verdict_shares,
           .position_rmse_m = score.methods.front().position_error_m.rmse};
    return trajectory;
  };
  std::vector<PoseEstimate> trajectory = likelierTrajectory(input, pass);
  return {std::move(trajectory), *row};
}

/// What the calibration starts from.
struct StartingPoint
{
  Settings settings;
  LocalizationInput input;
  std::vector<PoseEstimate> trajectory;
  std::vector<CalibratedValue> values;  // that differ from the configured ones
};

/// The pass as configured; where that is seldom `ok`, one with odometry that may err, if that is `ok` clearly more
/// often.
StartingPoint startingPoint(const Settings& settings, const LocalizationInput& input, FirstPass configured,
                            bool show_progress)
{
  StartingPoint start{settings, input, std::move(configured.trajectory), {}};
  const double ok = configured.row.shares.ok.value_or(0);
  if (ok >= kMostlyOk) return start;
  const std::vector<CalibratedValue> values = uncertainOdometry(input);
  if (values.empty()) return start;
  Settings uncertain = settings;
  for (const CalibratedValue& value : values) uncertain.set(value.section, value.key, value.value, kOrigin);
  LocalizationInput other = loadLocalization(uncertain, input.log.window);
  other.config.filter.threads = input.config.filter.threads;
  FirstPass pass = firstPass(other, show_progress, "first pass, odometry that may err");
  if (pass.row.shares.ok.value_or(0) < ok + kClearly) return start;
  return {std::move(uncertain), std::move(other), std::move(pass.trajectory), values};
}

/// The values in place of those of the same key.
void replace(std::vector<CalibratedValue>& values, const CalibratedValue& value)
{
  std::erase_if(values,
                [&](const CalibratedValue& old) { return old.section == value.section && old.key == value.key; });
  values.push_back(value);
}

/// What the mean log density of a reading gains by ranges of the likelier kind.
double gainOfDepths(const CalibrationData& data)
{
  double gain = 0;
  for (const DepthHypothesis& hypothesis : data.depths)
    if (hypothesis.differs()) gain += hypothesis.gain.gain;
  return gain / static_cast<double>(data.problem.readings.size());
}
}  // namespace

bool isAutoCalibrated(const LocalizationInput& input)
{
  const LocalizationConfig& config = input.config;
  const bool filtered = config.methods.empty() ||
                        std::find(config.methods.begin(), config.methods.end(), kFilterName) != config.methods.end();
  return config.auto_calibrate && filtered && !config.frames.independent && config.engine == FilterEngine::batch &&
         input.context.duration_s > kLeastDuration;
}

std::optional<AutoCalibration> autoCalibration(const Settings& settings, const LocalizationInput& input,
                                               bool show_progress)
{
  FirstPass pass = firstPass(input, show_progress);
  const CalibrationRow before = pass.row;
  const StartingPoint start = startingPoint(settings, input, std::move(pass), show_progress);
  CalibrationData data = collectCalibrationData(start.input, start.trajectory);
  const std::optional<LocalizationInput> likelier = withLikelierDepths(start.input, data);
  if (likelier) lookAgain(*likelier, firstPass(*likelier, show_progress).trajectory, data);
  const std::vector<CalibrationUnknown> unknowns = calibrationUnknowns(start.input, data);
  leaveOutRepeated(data, unknowns);
  const CalibrationChoice choice = chooseCalibration(data, unknowns, start.input.config);
  if (choice.empty() && !likelier && start.values.empty()) return std::nullopt;
  AutoCalibration result{start.settings,
                         {.values = start.values, .before = before, .log_density_after = choice.calibrated}};
  // Along another trajectory it is no measure of the configured one.
  if (start.values.empty()) result.adopted.before.log_density = choice.configured - gainOfDepths(data);
  for (const CalibrationFinding& finding : adoptedFindings(choice, data, start.input.config))
    replace(result.adopted.values, {finding.line.section, finding.line.key, finding.line.value, finding.std});
  for (const CalibratedValue& value : result.adopted.values)
    result.settings.set(value.section, value.key, value.value, kOrigin);
  if (result.adopted.values.empty()) return std::nullopt;
  return result;
}

std::string calibrationIni(const AdoptedCalibration& adopted)
{
  std::vector<IniAssignment> lines;
  for (const CalibratedValue& value : adopted.values)
    lines.push_back({value.section, value.key, withDeviation(value, "  ; ")});
  return withValues("; Found in the log by auto_calibrate. To keep it, copy the lines into your configuration.\n",
                    lines);
}
}  // namespace mrpt_ext
