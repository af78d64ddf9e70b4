#include <algorithm>
#include <cmath>

#include "mrpt_ext/likelihood/reading_likelihood.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"
#include "mrpt_ext/maps/CLandmarkMap2D.h"
#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/observations/usable_detections.h"

namespace mrpt_ext
{
namespace
{
/// MRPT's filters assert that every log-likelihood is finite; this is far below any that a detection can give.
constexpr double kLowestLogLikelihood = -1e6;

std::vector<Reading> usableReadings(LandmarkMeasurements measurements)
{
  std::vector<Reading> readings = std::move(measurements.readings);
  UnusableCounts unused;  // the reader of the log reports them, the map sees each observation many times
  for (Reading& reading : readings) removeUnusable(reading, unused);
  for (const RunningFixReading& fix : measurements.fixes)
    if (whyUnusable(fix).empty())
      for (Reading& reading : asReadings(fix)) readings.push_back(std::move(reading));
  return readings;
}
}  // namespace

std::optional<double> observationLogLikelihood(const mrpt::obs::CObservation& observation,
                                               const LandmarkTable& landmarks, const LandmarkLikelihoodOptions& options,
                                               const Pose2& robot)
{
  auto measurements = toMeasurements(observation);
  if (!measurements) return std::nullopt;
  double sum = 0;
  for (Reading& reading : usableReadings(std::move(*measurements)))
  {
    options.complete(reading);
    sum += logLikelihood(reading, landmarks, robot);
  }
  return std::isfinite(sum) ? std::max(sum, kLowestLogLikelihood) : kLowestLogLikelihood;
}
}  // namespace mrpt_ext
