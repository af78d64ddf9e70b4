#include "mrpt_ext/diagnosis/noise_candidates.h"

#include <algorithm>
#include <map>

#include "mrpt_ext/diagnosis/noise_findings.h"
#include "mrpt_ext/diagnosis/outlier_share.h"

namespace mrpt_ext
{
namespace
{
constexpr double kNoiseDiffers = 1.2;             // of deviations, either way
constexpr std::size_t kLeastNoiseReadings = 100;  // of a sensor, for its noise
constexpr double kToldNoise = 0.5;                // standard deviation of odometry's noise over the noise
constexpr double kCorrelated = 2;                 // standard deviations of an autocorrelation
constexpr double kMostOutlierShare = 0.5;

/// True where the trajectory predicts readings, by odometry and by other readings, better than they scatter. A
/// trajectory that is less certain follows the readings, with errors that last: what is left of them is how they repeat
/// themselves.
bool isToldByTrajectory(double scatter, double redundancy, double taken_up)
{
  return taken_up < square(scatter) * redundancy;  // variance of the prediction over the declared one, and found
}
}  // namespace

const SensorConfig& NoiseCandidates::configured(std::size_t sensor) const
{
  return configOf(config_.frames.sensors, data_.sensors[sensor]);
}

bool NoiseCandidates::isOther(std::size_t sensor, bool is_range) const
{
  const SensorScatter& found = found_.scatter[sensor];
  const SensorConfig& now = configured(sensor);
  if ((is_range ? found.ranges : found.bearings) < kLeastNoiseReadings || (is_range && now.std_range_per_m > 0) ||
      !areDeclaredAlike(data_.problem, sensor, is_range))
    return false;
  const double scatter = is_range ? found.range : found.bearing;
  const bool is_configured = is_range ? now.std_range.has_value() : now.std_bearing.has_value();
  if (scatter > kNoiseDiffers) return true;
  const bool is_told = is_range ? isToldByTrajectory(scatter, found.range_redundancy, found.range_taken_up)
                                : isToldByTrajectory(scatter, found.bearing_redundancy, found.bearing_taken_up);
  return scatter < 1 / kNoiseDiffers && !is_configured && is_told && !areCorrelated(sensor, is_range);
}

/// True where successive misfits of one landmark, by one sensor, are correlated: its errors last, or odometry errs by
/// more than readings of the stated deviation correct. Either way they tell less than they seem to.
bool NoiseCandidates::areCorrelated(std::size_t sensor, bool is_range) const
{
  // The readings that stay are independent, but a filter takes all of them.
  const auto time = data_.correlation_times.find({sensor, is_range});
  if (time != data_.correlation_times.end() && time->second > 0) return true;
  std::map<std::size_t, double> before;  // by landmark
  double product = 0, power = 0, pairs = 0;
  for (std::size_t i = 0; i < found_.misfits.size(); ++i)
  {
    const CalibrationReading& r = data_.problem.readings[i];
    const double misfit = found_.misfits[i];
    if (r.sensor != sensor || r.is_range != is_range || std::abs(misfit) > kOutlierMisfit) continue;
    const auto [last, is_new] = before.try_emplace(r.landmark_number, misfit);
    if (is_new) continue;
    product += last->second * misfit;
    power += square(misfit);
    ++pairs;
    last->second = misfit;
  }
  return product * std::sqrt(pairs) > kCorrelated * power || power == 0;
}

bool NoiseCandidates::isOther(MotionNoise noise) const
{
  if (data_.problem.odometry.empty()) return false;
  return found_.odometry_scatter[noise] > kNoiseDiffers || isLess(noise, found_);
}

bool NoiseCandidates::isLess(MotionNoise noise, const CalibrationResult& found) const
{
  const double scatter = found.odometry_scatter[noise];
  return !config_.odometry_noise_stated && scatter < 1 / kNoiseDiffers &&
         found.odometry_scatter_std[noise] < kToldNoise * scatter;
}

double NoiseCandidates::moreOutliers(std::size_t sensor) const
{
  if (!data_.verified) return 0;  // a wrong pose has outliers, too
  const OutlierShare outliers = outlierShare(data_, found_.misfits, sensor, end_);
  if (outliers.matched < kLeastNoiseReadings) return 0;
  const double share = std::min(outliers.share, kMostOutlierShare);
  return share > kNoiseDiffers * configured(sensor).clutter_probability ? share : 0;
}

PerMotionNoise<double> NoiseCandidates::odometryBeside(double scatter, const CalibrationResult& found) const
{
  PerMotionNoise<double> odometry{1, 1};
  if (scatter <= 1 || data_.problem.odometry.empty()) return odometry;
  for (const MotionNoise noise : {position_noise, heading_noise})
    if (isLess(noise, found)) odometry[noise] = found.odometry_scatter[noise];
  return odometry;
}
}  // namespace mrpt_ext
