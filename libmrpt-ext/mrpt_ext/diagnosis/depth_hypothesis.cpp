#include "mrpt_ext/diagnosis/depth_hypothesis.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/diagnosis/partial_calibration.h"

namespace mrpt_ext
{
namespace
{
constexpr double kToldGain = 2;       // standard deviations of a gain
constexpr double kNarrowField = 0.3;  // least cosine of a bearing

/// Cosines of the bearings that the sensor's ranges were measured with, by reading; 0: no range with a bearing.
std::vector<double> depthShares(const CalibrationProblem& problem, std::size_t sensor)
{
  std::vector<double> shares(problem.readings.size(), 0);
  for (std::size_t i = 1; i < shares.size(); ++i)
  {
    const CalibrationReading &range = problem.readings[i], &bearing = problem.readings[i - 1];
    if (range.sensor == sensor && bearing.sensor == sensor && range.is_range && !bearing.is_range &&
        range.pose == bearing.pose && range.landmark_number == bearing.landmark_number)
      shares[i] = std::cos(bearing.value);
  }
  return shares;
}

bool isNarrow(const CalibrationProblem& problem, std::size_t sensor)
{
  return std::all_of(problem.readings.begin(), problem.readings.end(),
                     [&](const CalibrationReading& r)
                     { return r.sensor != sensor || r.is_range || std::cos(r.value) > kNarrowField; });
}

/// Densities of the readings from pose `middle` on, with errors and noise from those before it; empty: the first half
/// does not tell them.
std::vector<double> densitiesOf(const CalibrationProblem& problem, std::size_t middle,
                                const std::vector<CalibrationUnknown>& unknowns, RecordingModel model)
{
  const CalibrationResult found = calibrate(firstPart(problem, middle), unknowns);
  if (found.status != SolveStatus::ok) return {};
  for (const ParameterEstimate& error : found.errors)
    if (error.observable) model.errors.push_back({.unknown = error.unknown, .mean = error.value});
  for (std::size_t s = 0; s < problem.sensors; ++s)
  {
    model.sensors[s].bearing = found.scatter[s].bearing;
    model.sensors[s].range = found.scatter[s].range;
  }
  model.odometry = found.odometry_scatter;
  return predictiveLogDensities(problem, model, middle);
}

std::optional<DepthHypothesis> chooseDepth(CalibrationProblem& problem, std::size_t sensor, bool is_depth,
                                           const std::vector<CalibrationUnknown>& unknowns, const RecordingModel& model)
{
  const std::vector<double> shares = depthShares(problem, sensor);
  if (!isNarrow(problem, sensor) || std::none_of(shares.begin(), shares.end(), [](double c) { return c > 0; }))
    return std::nullopt;
  CalibrationProblem other = problem;
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i] > 0) other.readings[i].value *= is_depth ? shares[i] : 1 / shares[i];
  const std::size_t middle = middleOf(problem);
  const std::vector<double> before = densitiesOf(problem, middle, unknowns, model);
  std::vector<double> after = densitiesOf(other, middle, unknowns, model);
  DepthHypothesis hypothesis{.sensor = sensor, .configured = is_depth, .likelier = is_depth};
  if (before.empty() || after.empty()) return hypothesis;
  for (std::size_t i = 0; i < shares.size(); ++i)  // densities of what was measured
    if (shares[i] > 0) after[i] += is_depth ? std::log(shares[i]) : -std::log(shares[i]);
  hypothesis.gain = predictiveGain(problem, middle, after, before);
  hypothesis.told = std::abs(hypothesis.gain.gain) > kToldGain * hypothesis.gain.std;
  hypothesis.likelier = is_depth != (hypothesis.told && hypothesis.gain.gain > 0);
  if (hypothesis.likelier != is_depth) problem = std::move(other);
  return hypothesis;
}
}  // namespace

std::vector<DepthHypothesis> chooseDepths(CalibrationProblem& problem, const std::vector<bool>& is_depth,
                                          const std::vector<CalibrationUnknown>& unknowns, const RecordingModel& model)
{
  std::vector<DepthHypothesis> chosen;
  for (std::size_t sensor = 0; sensor < problem.sensors; ++sensor)
    if (const auto hypothesis = chooseDepth(problem, sensor, is_depth[sensor], unknowns, model))
      chosen.push_back(*hypothesis);
  return chosen;
}
}  // namespace mrpt_ext
