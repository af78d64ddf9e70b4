#include "mrpt_ext/diagnosis/depth_hypothesis.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mrpt_ext/diagnosis/partial_calibration.h"

namespace mrpt_ext
{
namespace
{
constexpr double kToldGain = 2;       // standard deviations of a gain
constexpr double kNarrowField = 0.3;  // least cosine of a bearing

/// What turns the sensor's ranges into those of the other kind, by reading: the cosine to the axis, as logged, or its
/// inverse; nothing where there is none.
std::vector<std::optional<double>> factorsToOther(const CalibrationProblem& problem, std::size_t sensor, bool is_depth)
{
  std::vector<std::optional<double>> factors;
  for (const CalibrationReading& r : problem.readings)
  {
    std::optional<double>& factor = factors.emplace_back();
    if (r.sensor != sensor || !r.off_axis) continue;
    factor = is_depth ? std::cos(*r.off_axis) : 1 / std::cos(*r.off_axis);
  }
  return factors;
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
  if (!looksAhead(problem, sensor)) return std::nullopt;
  const std::vector<std::optional<double>> factors = factorsToOther(problem, sensor, is_depth);
  if (std::none_of(factors.begin(), factors.end(), [](const auto& factor) { return factor.has_value(); }))
    return std::nullopt;
  CalibrationProblem other = problem;
  for (std::size_t i = 0; i < factors.size(); ++i)
    if (factors[i]) other.readings[i].value *= *factors[i];
  const std::size_t middle = middleOf(problem);
  const std::vector<double> before = densitiesOf(problem, middle, unknowns, model);
  std::vector<double> after = densitiesOf(other, middle, unknowns, model);
  DepthHypothesis hypothesis{.sensor = sensor, .configured = is_depth, .likelier = is_depth};
  if (before.empty() || after.empty()) return hypothesis;
  for (std::size_t i = 0; i < factors.size(); ++i)  // densities of what was measured
    if (factors[i]) after[i] += std::log(*factors[i]);
  hypothesis.gain = predictiveGain(problem, middle, after, before);
  hypothesis.told = std::abs(hypothesis.gain.gain) > kToldGain * hypothesis.gain.std;
  hypothesis.likelier = is_depth != (hypothesis.told && hypothesis.gain.gain > 0);
  if (hypothesis.differs()) problem = std::move(other);
  return hypothesis;
}
}  // namespace

bool looksAhead(const CalibrationProblem& problem, std::size_t sensor)
{
  return std::all_of(problem.readings.begin(), problem.readings.end(),
                     [&](const CalibrationReading& r)
                     {
                       const std::optional<double> angle = r.is_range ? r.off_axis : r.value;
                       return r.sensor != sensor || !angle || std::cos(*angle) > kNarrowField;
                     });
}

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
