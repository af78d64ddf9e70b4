#include "mrpt_ext/diagnosis/noise_findings.h"

#include <algorithm>
#include <map>

#include "mrpt_ext/diagnosis/outlier_share.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStdOfMedian = 1.17;       // of a median absolute deviation, times the root of their number
constexpr double kSignificantNoise = 3;     // standard deviations
constexpr double kManyOutliers = 1.5;       // estimated over configured share
constexpr double kUsefulShare = 0.5;        // standard deviation of a noise over the noise
constexpr std::size_t kLeastReadings = 50;  // of a sensor
constexpr std::size_t kNoiseBlocks = 20, kLeastNoiseBlocks = 8, kLeastInNoiseBlock = 10;

/// Standard deviation of a sensor's scatter over the scatter: the larger of that of independent readings, and that by
/// which blocks of time disagree.
double relativeScatterStd(const CalibrationResult& errors, const CalibrationData& data, std::size_t sensor,
                          bool is_range)
{
  const SensorScatter& scatter = errors.scatter[sensor];
  const double redundancy = is_range ? scatter.range_redundancy : scatter.bearing_redundancy;
  const double independent = kStdOfMedian / std::sqrt(std::max(redundancy, 1.0));
  std::vector<double> sizes;
  for (std::size_t i = 0; i < errors.misfits.size(); ++i)
    if (const CalibrationReading& r = data.problem.readings[i];
        r.sensor == sensor && r.is_range == is_range && std::abs(errors.misfits[i]) < kOutlierMisfit)
      sizes.push_back(std::abs(errors.misfits[i]));
  const std::size_t blocks = std::min(kNoiseBlocks, sizes.size() / kLeastInNoiseBlock);
  if (blocks < kLeastNoiseBlocks) return independent;
  double sum = 0, squares = 0;
  for (std::size_t b = 0; b < blocks; ++b)
  {
    const auto at = [&](std::size_t block)
    { return sizes.begin() + static_cast<std::ptrdiff_t>(block * sizes.size() / blocks); };
    const double typical = upperMedian(std::vector<double>(at(b), at(b + 1)));
    sum += typical;
    squares += square(typical);
  }
  const auto count = static_cast<double>(blocks);
  const double mean = sum / count, variance = std::max(squares / count - square(mean), 0.0) / (count - 1);
  return std::max(independent, mean > 0 ? std::sqrt(variance) / mean : 0);
}

/// One per sensor.
std::vector<CalibrationFinding> outlierFindings(const CalibrationResult& errors, const CalibrationData& data,
                                                const LocalizationConfig& config)
{
  std::vector<CalibrationFinding> findings;
  for (std::size_t sensor = 0; sensor < data.sensors.size(); ++sensor)
  {
    const OutlierShare outliers = outlierShare(data, errors.misfits, sensor);
    if (outliers.matched == 0) continue;
    const std::string& label = data.sensors[sensor];
    CalibrationFinding found{.what = label + ": share of outliers",
                             .configured = configOf(config.frames.sensors, label).clutter_probability,
                             .estimate = outliers.share,
                             .std = outliers.std,
                             .decimals = 3,
                             .line = {"Sensor_" + label, "clutter_probability", ""}};
    settleLine(found, outliers.matched >= kLeastReadings && outliers.share > kManyOutliers * found.configured);
    findings.push_back(found);
  }
  return findings;
}

std::vector<CalibrationFinding> measurementNoiseFindings(const CalibrationResult& errors, const CalibrationData& data,
                                                         const LocalizationConfig& config)
{
  std::map<std::pair<std::size_t, bool>, std::vector<double>> stds;  // declared, by sensor and whether it is a range
  for (const CalibrationReading& r : data.problem.readings) stds[{r.sensor, r.is_range}].push_back(r.std);
  std::vector<CalibrationFinding> findings;
  for (const auto& [key, of] : stds)
  {
    const auto& [sensor, is_range] = key;
    const std::string label = data.sensors[sensor], section = "Sensor_" + label;
    const SensorConfig& now = configOf(config.frames.sensors, label);
    const double unit = is_range ? 1 : radToDeg(1.0), declared = unit * upperMedian(of);
    const double scatter = is_range ? errors.scatter[sensor].range : errors.scatter[sensor].bearing;
    CalibrationFinding spread{.what = label + (is_range ? ": std of ranges" : ": std of bearings"),
                              .unit = is_range ? "m" : "deg",
                              .configured = declared,
                              .estimate = scatter * declared,
                              .std = scatter * declared * relativeScatterStd(errors, data, sensor, is_range),
                              .decimals = is_range ? 3 : 2,
                              .line = {section, is_range ? "std_range_m" : "std_bearing_deg", ""}};
    const bool more = of.size() >= kLeastReadings && spread.estimate > declared + kSignificantNoise * spread.std;
    const bool is_alike = areDeclaredAlike(data.problem, sensor, is_range) && !(is_range && now.std_range_per_m > 0);
    if (more && !is_alike) spread.remark = fixedText(scatter, 2) + " times what is declared reading by reading";
    settleLine(spread, more && is_alike);
    findings.push_back(spread);
  }
  for (CalibrationFinding& outliers : outlierFindings(errors, data, config)) findings.push_back(std::move(outliers));
  return findings;
}

std::vector<CalibrationFinding> odometryNoiseFindings(const CalibrationResult& errors, const CalibrationData& data,
                                                      const LocalizationConfig& config)
{
  std::size_t links = 0;
  for (const TrajectoryPose& pose : data.problem.poses) links += pose.since_previous ? 1 : 0;
  if (data.problem.odometry.empty() || links == 0) return {};
  const MotionModel& now = config.filter.motion;
  std::vector<CalibrationFinding> findings;
  const auto add = [&](const char* key, MotionNoise noise, double configured, const char* unit)
  {
    const double factor = errors.odometry_scatter[noise], std = errors.odometry_scatter_std[noise];
    const bool told = std <= kUsefulShare * factor;
    CalibrationFinding found{.what = std::string("odometry: ") + key,
                             .unit = unit,
                             .configured = configured,
                             .estimate = factor * configured,
                             .std = told ? std * configured : 0,
                             .decimals = 4,
                             .why_not_observable = told ? "" : "readings do not tell it from their own noise",
                             .line = {"MotionModel", key, ""}};
    settleLine(found, factor > 1 + kSignificantNoise * std);
    findings.push_back(found);
  };
  add("std_xy_per_m", position_noise, now.std_xy_per_m, "m");
  add("std_phi_deg_per_deg", heading_noise, now.std_phi_per_deg, "deg");
  add("std_phi_deg_per_m", heading_noise, radToDeg(now.std_phi_per_m), "deg");
  return findings;
}
}  // namespace

bool areDeclaredAlike(const CalibrationProblem& problem, std::size_t sensor, bool is_range)
{
  std::optional<double> std;
  for (const CalibrationReading& r : problem.readings)
  {
    if (r.sensor != sensor || r.is_range != is_range) continue;
    if (std && std::abs(r.std - *std) > 1e-6 * *std) return false;
    std = r.std;
  }
  return std.has_value();
}

std::vector<CalibrationFinding> noiseFindings(const CalibrationResult& errors, const CalibrationData& data,
                                              const LocalizationConfig& config)
{
  std::vector<CalibrationFinding> findings = measurementNoiseFindings(errors, data, config);
  for (CalibrationFinding& finding : odometryNoiseFindings(errors, data, config))
    findings.push_back(std::move(finding));
  return findings;
}
}  // namespace mrpt_ext
