#include "mrpt_ext/calibration/independent_readings.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kUncorrelated = 1 / std::numbers::e;
constexpr double kShortest = 0.1, kLongest = 12.8;  // [s] of the spacings, but for none
constexpr std::size_t kFewestPairs = 20;
constexpr double kJitter = 0.01;  // [s] of the stamps of a sensor that measures at a rate

/// Readings of one landmark by one sensor, of one kind.
using Series = std::vector<std::size_t>;
using SeriesByLandmark = std::map<std::size_t, Series>;

std::map<std::pair<std::size_t, bool>, SeriesByLandmark> seriesOf(const CalibrationProblem& problem)
{
  std::map<std::pair<std::size_t, bool>, SeriesByLandmark> all;
  for (std::size_t i = 0; i < problem.readings.size(); ++i)
  {
    const CalibrationReading& r = problem.readings[i];
    all[{r.sensor, r.is_range}][r.landmark_number].push_back(i);
  }
  return all;
}

/// Those that are at least `spacing` after the one before that is kept.
Series spaced(const CalibrationProblem& problem, const Series& series, double spacing)
{
  Series kept;
  const auto time = [&](std::size_t reading) { return problem.poses[problem.readings[reading].pose].time; };
  for (const std::size_t reading : series)
    if (kept.empty() || time(reading) - time(kept.back()) >= spacing - kJitter) kept.push_back(reading);
  return kept;
}

/// Of successive misfits; nothing for few.
std::optional<double> autocorrelation(const CalibrationProblem& problem, const std::vector<double>& misfits,
                                      const SeriesByLandmark& landmarks, double spacing)
{
  double product = 0, power = 0;
  std::size_t pairs = 0;
  const auto misfit = [&](std::size_t reading)
  { return std::clamp(misfits[reading], -kOutlierMisfit, kOutlierMisfit); };
  for (const auto& [landmark, series] : landmarks)
  {
    const Series kept = spaced(problem, series, spacing);
    for (std::size_t k = 1; k < kept.size(); ++k)
    {
      product += misfit(kept[k - 1]) * misfit(kept[k]);
      power += (square(misfit(kept[k - 1])) + square(misfit(kept[k]))) / 2;
      ++pairs;
    }
  }
  if (pairs < kFewestPairs || !(power > 0)) return {};
  return product / power;
}
}  // namespace

CorrelationTimes correlationTimes(const CalibrationProblem& problem, const std::vector<double>& misfits)
{
  CorrelationTimes times;
  for (const auto& [kind, landmarks] : seriesOf(problem))
  {
    double& spacing = times[kind];
    while (spacing < kLongest && autocorrelation(problem, misfits, landmarks, spacing) > kUncorrelated)
      spacing = std::max(kShortest, 2 * spacing);
  }
  return times;
}

std::vector<bool> independentReadings(const CalibrationProblem& problem, const CorrelationTimes& times)
{
  std::vector<bool> independent(problem.readings.size(), false);
  for (const auto& [kind, landmarks] : seriesOf(problem))
  {
    const auto time = times.find(kind);
    for (const auto& [landmark, series] : landmarks)
      for (const std::size_t reading : spaced(problem, series, time == times.end() ? 0 : time->second))
        independent[reading] = true;
  }
  return independent;
}
}  // namespace mrpt_ext
