#include "mrpt_ext/diagnosis/noise_findings.h"

#include <algorithm>
#include <map>

#include "mrpt_ext/diagnosis/outlier_share.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStdOfMedian = 1.17;       // of a median absolute deviation, times the root of their number
constexpr double kSignificantRatio = 1.5;   // estimated over configured
constexpr double kUsefulShare = 0.5;        // standard deviation of a noise over the noise
constexpr std::size_t kLeastReadings = 50;  // of a sensor

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
    settleLine(found, outliers.matched >= kLeastReadings && outliers.share > kSignificantRatio * found.configured);
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
    const double redundancy =
        is_range ? errors.scatter[sensor].range_redundancy : errors.scatter[sensor].bearing_redundancy;
    CalibrationFinding spread{.what = label + (is_range ? ": std of ranges" : ": std of bearings"),
                              .unit = is_range ? "m" : "deg",
                              .configured = declared,
                              .estimate = scatter * declared,
                              .std = scatter * declared * kStdOfMedian / std::sqrt(std::max(redundancy, 1.0)),
                              .decimals = is_range ? 3 : 2,
                              .line = {section, is_range ? "std_range_m" : "std_bearing_deg", ""}};
    const bool enough = of.size() >= kLeastReadings;
    settleLine(spread, enough && scatter > kSignificantRatio && !(is_range && now.std_range_per_m > 0));
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
    settleLine(found, factor > kSignificantRatio);
    findings.push_back(found);
  };
  add("std_xy_per_m", position_noise, now.std_xy_per_m, "m");
  add("std_phi_deg_per_deg", heading_noise, now.std_phi_per_deg, "deg");
  add("std_phi_deg_per_m", heading_noise, radToDeg(now.std_phi_per_m), "deg");
  return findings;
}
}  // namespace

std::vector<CalibrationFinding> noiseFindings(const CalibrationResult& errors, const CalibrationData& data,
                                              const LocalizationConfig& config)
{
  std::vector<CalibrationFinding> findings = measurementNoiseFindings(errors, data, config);
  for (CalibrationFinding& finding : odometryNoiseFindings(errors, data, config))
    findings.push_back(std::move(finding));
  return findings;
}
}  // namespace mrpt_ext
