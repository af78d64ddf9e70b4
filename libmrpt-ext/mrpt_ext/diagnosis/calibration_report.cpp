#include "mrpt_ext/diagnosis/calibration_report.h"

#include <algorithm>
#include <map>

#include "mrpt_ext/configuration/bias_config.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSignificant = 3;          // standard deviations
constexpr double kOutlier = 4;              // standard deviations
constexpr double kStdOfMedian = 1.17;       // of a median absolute deviation, times the root of their number
constexpr double kSignificantRatio = 1.5;   // estimated over configured
constexpr std::size_t kLeastReadings = 50;  // of a sensor

const std::string kMotion = "MotionModel";

std::string whyNotObservable(CalibrationParameter kind)
{
  switch (kind)
  {
    case CalibrationParameter::delay:
      return "the robot moves too little or too evenly";
    case CalibrationParameter::lever_arm_x:
    case CalibrationParameter::lever_arm_y:
      return "not separable from delay and heading";
    case CalibrationParameter::bearing_offset:
      return "not separable from the heading";
    case CalibrationParameter::range_offset:
    case CalibrationParameter::range_scale:
      return "too few different ranges";
    case CalibrationParameter::rotation_scale:
      return "too few turns";
    case CalibrationParameter::veer:
    case CalibrationParameter::drift:
      return "veer and drift are not separable: no rests";
    default:
      return "too short a trajectory";
  }
}

/// Converts estimated errors into values of the configuration.
class Translator
{
 public:
  Translator(const CalibrationResult& errors, const std::vector<std::string>& sensors, const LocalizationConfig& config)
      : errors_(errors), sensors_(sensors), config_(config)
  {
  }

  [[nodiscard]] CalibrationFinding finding(const ParameterEstimate& error) const
  {
    CalibrationFinding found = isOfOdometry(error.unknown.parameter) ? ofOdometry(error) : ofSensor(error);
    if (!error.observable) found.why_not_observable = whyNotObservable(error.unknown.parameter);
    return found;
  }

 private:
  [[nodiscard]] double valueOf(CalibrationParameter kind) const
  {
    for (const ParameterEstimate& error : errors_.errors)
      if (error.unknown.parameter == kind) return error.value;
    return 0;
  }

  /// The value is `base + scale * error`.
  static void set(CalibrationFinding& found, const ParameterEstimate& error, double base, double scale)
  {
    found.configured = base;
    found.estimate = base + scale * error.value;
    found.std = std::abs(scale) * error.std;
  }

  /// Where the configuration states the mean of this error for its estimation, the finding is that mean.
  bool setAsMean(CalibrationFinding& found, const ParameterEstimate& error, BiasKind kind,
                 const std::string& label) const
  {
    for (const BiasState& bias : config_.biases)
    {
      const bool acts = belongsToOdometry(kind) || bias.sensor.empty() || bias.sensor == label;
      if (bias.kind != kind || !acts || bias.mean == 0) continue;
      const double unit = kind == BiasKind::bearing_offset ? radToDeg(1.0) : 1;
      set(found, error, 0, unit);
      found.configured = unit * bias.mean;
      found.line = {bias.sensor.empty() ? "Bias" : "Sensor_" + bias.sensor, biasMeanKey(kind), ""};
      return true;
    }
    return false;
  }

  [[nodiscard]] CalibrationFinding ofOdometry(const ParameterEstimate& error) const
  {
    const OdometryCorrection& now = config_.frames.odometry;
    CalibrationFinding found;
    if (error.unknown.parameter == CalibrationParameter::distance_scale)
    {
      found = {.what = "odometry: true over measured distance", .decimals = 4, .line = {kMotion, "odometry_scale", ""}};
      set(found, error, now.scale, now.scale);
      if (setAsMean(found, error, BiasKind::distance_scale, "")) found.what = "odometry: relative error of distance";
    }
    if (error.unknown.parameter == CalibrationParameter::rotation_scale)
    {
      found = {.what = "odometry: true over measured rotation",
               .decimals = 4,
               .line = {kMotion, "odometry_rotation_scale", ""}};
      set(found, error, now.rotation_scale, now.rotation_scale);
      if (setAsMean(found, error, BiasKind::rotation_scale, "")) found.what = "odometry: relative error of rotation";
    }
    if (error.unknown.parameter == CalibrationParameter::veer)
    {
      found = {.what = "odometry: unmeasured left turn per metre",
               .unit = "deg",
               .decimals = 2,
               .line = {kMotion, "odometry_turn_per_m_deg", ""}};
      // The configured value scales with the rotations, and is per metre of the uncorrected distance.
      const double base = now.turn_per_m * (1 + valueOf(CalibrationParameter::rotation_scale)) /
                          (1 + valueOf(CalibrationParameter::distance_scale));
      set(found, error, radToDeg(base), radToDeg(1.0));
      found.configured = radToDeg(now.turn_per_m);
    }
    if (error.unknown.parameter == CalibrationParameter::drift)
    {
      found = {.what = "odometry: unmeasured left turn per second",
               .unit = "deg/s",
               .decimals = 3,
               .line = {kMotion, "odometry_turn_per_s_deg", ""}};
      const double base = now.turn_per_s * (1 + valueOf(CalibrationParameter::rotation_scale));
      set(found, error, radToDeg(base), radToDeg(1.0));
      found.configured = radToDeg(now.turn_per_s);
    }
    return found;
  }

  [[nodiscard]] CalibrationFinding ofSensor(const ParameterEstimate& error) const
  {
    const std::string label = sensors_[error.unknown.sensor], section = "Sensor_" + label;
    const SensorConfig& now = configOf(config_.frames.sensors, label);
    CalibrationFinding found;
    switch (error.unknown.parameter)
    {
      case CalibrationParameter::delay:
        return delay(error, label, now);
      case CalibrationParameter::lever_arm_x:
        found = {.what = label + ": further forward than stated", .unit = "m", .line = {section, "lever_arm_x_m", ""}};
        set(found, error, now.lever_arm.x(), 1);
        return found;
      case CalibrationParameter::lever_arm_y:
        found = {.what = label + ": further left than stated", .unit = "m", .line = {section, "lever_arm_y_m", ""}};
        set(found, error, now.lever_arm.y(), 1);
        return found;
      case CalibrationParameter::bearing_offset:
        found = {.what = label + ": bearing offset",
                 .unit = "deg",
                 .decimals = 2,
                 .line = {section, "bias_bearing_deg", ""}};
        set(found, error, radToDeg(now.bias_bearing), radToDeg(now.scale_bearing));
        setAsMean(found, error, BiasKind::bearing_offset, label);
        return found;
      case CalibrationParameter::range_offset:
        found = {.what = label + ": range offset", .unit = "m", .line = {section, "bias_range_m", ""}};
        set(found, error, now.bias_range, now.scale_range);
        setAsMean(found, error, BiasKind::range_offset, label);
        return found;
      default:
        found = {.what = label + ": measured over true range", .decimals = 4, .line = {section, "scale_range", ""}};
        set(found, error, now.scale_range, now.scale_range);
        if (setAsMean(found, error, BiasKind::range_scale, label)) found.what = label + ": relative error of ranges";
        return found;
    }
  }

  [[nodiscard]] CalibrationFinding delay(const ParameterEstimate& error, const std::string& label,
                                         const SensorConfig& now) const
  {
    const bool odometry_is_late = config_.frames.odometry.delay != 0 && sensors_.size() == 1;
    CalibrationFinding found{.what = odometry_is_late ? "odometry: latency" : label + ": delay against odometry",
                             .unit = "s",
                             .line = odometry_is_late ? IniAssignment{kMotion, "odometry_delay_s", ""}
                                                      : IniAssignment{"Sensor_" + label, "delay_s", ""}};
    set(found, error, odometry_is_late ? config_.frames.odometry.delay : now.delay, 1);
    return found;
  }

  const CalibrationResult& errors_;
  const std::vector<std::string>& sensors_;
  const LocalizationConfig& config_;
};

void settleLine(CalibrationFinding& found, bool differs)
{
  found.differs = differs && found.why_not_observable.empty();
  found.line.value = fixedText(found.estimate, found.decimals);
}

bool differs(const CalibrationFinding& found)
{
  return found.why_not_observable.empty() && std::abs(found.estimate - found.configured) > kSignificant * found.std;
}

/// Bearings or ranges of one sensor.
struct Residuals
{
  std::vector<double> stds;  // declared
  double outliers = 0;
};

/// By number of the sensor and whether they are ranges.
using ResidualsBySensor = std::map<std::pair<std::size_t, bool>, Residuals>;

/// Of the detections of each sensor: those far from the landmark they were matched with, and those near none.
std::vector<CalibrationFinding> outlierFindings(const ResidualsBySensor& by_sensor, const CalibrationData& data,
                                                const LocalizationConfig& config)
{
  std::map<std::size_t, CalibrationFinding> findings;
  for (const auto& [key, of] : by_sensor)
  {
    const std::size_t sensor = key.first;
    const std::string& label = data.sensors[sensor];
    const auto left_out = data.unmatched.find(label);
    const double unmatched = left_out == data.unmatched.end() ? 0 : static_cast<double>(left_out->second);
    const double count = static_cast<double>(of.stds.size()) + unmatched, share = (of.outliers + unmatched) / count;
    CalibrationFinding found{.what = label + ": share of outliers",
                             .configured = configOf(config.frames.sensors, label).clutter_probability,
                             .estimate = share,
                             .std = std::sqrt(share * (1 - share) / count),
                             .decimals = 3,
                             .line = {"Sensor_" + label, "clutter_probability", ""}};
    settleLine(found, of.stds.size() >= kLeastReadings && share > kSignificantRatio * found.configured);
    // Bearings and ranges of a sensor have one key: the worse of them counts.
    const auto [entry, is_new] = findings.try_emplace(sensor, found);
    if (!is_new && share > entry->second.estimate) entry->second = found;
  }
  std::vector<CalibrationFinding> list;
  for (auto& [sensor, found] : findings) list.push_back(std::move(found));
  return list;
}

bool isOfRanges(const ParameterEstimate& error)
{
  return error.unknown.parameter == CalibrationParameter::range_offset ||
         error.unknown.parameter == CalibrationParameter::range_scale;
}

std::vector<CalibrationFinding> measurementNoiseFindings(const CalibrationResult& errors, const CalibrationData& data,
                                                         const LocalizationConfig& config)
{
  ResidualsBySensor by_sensor;
  for (std::size_t i = 0; i < errors.misfits.size(); ++i)
  {
    const CalibrationReading& r = data.problem.readings[i];
    Residuals& of = by_sensor[{r.sensor, r.is_range}];
    of.stds.push_back(r.std);
    of.outliers += std::abs(errors.misfits[i]) > kOutlier;
  }
  std::vector<CalibrationFinding> findings;
  for (const auto& [key, of] : by_sensor)
  {
    const auto& [sensor, is_range] = key;
    const std::string label = data.sensors[sensor], section = "Sensor_" + label;
    const SensorConfig& now = configOf(config.frames.sensors, label);
    const double unit = is_range ? 1 : radToDeg(1.0), declared = unit * upperMedian(of.stds);
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
    const bool enough = of.stds.size() >= kLeastReadings;
    settleLine(spread, enough && scatter > kSignificantRatio && !(is_range && now.std_range_per_m > 0));
    findings.push_back(spread);
  }
  for (CalibrationFinding& outliers : outlierFindings(by_sensor, data, config)) findings.push_back(std::move(outliers));
  return findings;
}

std::vector<CalibrationFinding> odometryNoiseFindings(const CalibrationResult& errors, const CalibrationData& data,
                                                      const LocalizationConfig& config)
{
  std::size_t links = 0;
  for (const TrajectoryPose& pose : data.problem.poses) links += pose.since_previous ? 1 : 0;
  if (data.problem.odometry.empty() || links == 0) return {};
  const MotionModel& now = config.filter.motion;
  const double factor = errors.odometry_scatter,
               relative_std = 1 / std::sqrt(2 * std::max(errors.odometry_redundancy, 1.0));
  const bool larger = factor > kSignificantRatio;
  std::vector<CalibrationFinding> findings;
  const auto add = [&](const char* key, double configured, const char* unit)
  {
    CalibrationFinding found{.what = std::string("odometry: ") + key,
                             .unit = unit,
                             .configured = configured,
                             .estimate = factor * configured,
                             .std = factor * configured * relative_std,
                             .decimals = 4,
                             .line = {kMotion, key, ""}};
    settleLine(found, larger);
    findings.push_back(found);
  };
  add("std_xy_per_m", now.std_xy_per_m, "m");
  add("std_phi_deg_per_deg", now.std_phi_per_deg, "deg");
  add("std_phi_deg_per_m", radToDeg(now.std_phi_per_m), "deg");
  return findings;
}
}  // namespace

std::vector<CalibrationFinding> calibrationFindings(const CalibrationResult& errors,
                                                    const std::vector<std::string>& sensors,
                                                    const LocalizationConfig& config)
{
  const Translator translator(errors, sensors, config);
  std::vector<CalibrationFinding> findings;
  for (const ParameterEstimate& error : errors.errors) findings.push_back(translator.finding(error));
  for (std::size_t k = 0; k < findings.size(); ++k)
  {
    const ParameterEstimate& error = errors.errors[k];
    bool set = differs(findings[k]);
    for (std::size_t j = 0; j < findings.size() && isOfRanges(error); ++j)
      set = set || (isOfRanges(errors.errors[j]) && errors.errors[j].unknown.sensor == error.unknown.sensor &&
                    differs(findings[j]));
    settleLine(findings[k], set);
  }
  return findings;
}

std::vector<CalibrationFinding> noiseFindings(const CalibrationResult& errors, const CalibrationData& data,
                                              const LocalizationConfig& config)
{
  std::vector<CalibrationFinding> findings = measurementNoiseFindings(errors, data, config);
  for (CalibrationFinding& finding : odometryNoiseFindings(errors, data, config))
    findings.push_back(std::move(finding));
  return findings;
}

std::vector<std::string> landmarkLines(const CalibrationResult& errors, const CalibrationData& data,
                                       const LandmarkTable& map)
{
  struct Count
  {
    std::size_t readings = 0, outliers = 0;
  };
  std::map<std::size_t, Count> counts;
  for (std::size_t i = 0; i < errors.misfits.size(); ++i)
  {
    Count& count = counts[data.landmarks[i]];
    ++count.readings;
    count.outliers += std::abs(errors.misfits[i]) > kOutlier;
  }
  std::vector<std::string> lines;
  for (const auto& [landmark, count] : counts)
  {
    const Landmark& of = map[landmark];
    const std::string name = of.id != kNoId
                                 ? std::to_string(of.id)
                                 : "at " + fixedText(of.position.x(), 2) + " " + fixedText(of.position.y(), 2);
    const double share = static_cast<double>(count.outliers) / static_cast<double>(count.readings);
    lines.push_back("landmark " + name + ": " + std::to_string(count.readings) + " bearings and ranges, " +
                    fixedText(100 * share, 1) + " % outliers");
  }
  return lines;
}

std::vector<std::string> findingsTable(const std::vector<CalibrationFinding>& findings)
{
  std::vector<std::vector<std::string>> rows{{"", "estimated", "configured", ""}};
  for (const CalibrationFinding& f : findings)
  {
    const std::string unit = f.unit.empty() ? "" : " " + f.unit;
    const std::string estimate = fixedText(f.estimate, f.decimals) + " +- " + fixedText(f.std, f.decimals) + unit;
    rows.push_back({f.what, f.why_not_observable.empty() ? estimate : "not observable",
                    fixedText(f.configured, f.decimals) + unit,
                    !f.why_not_observable.empty() ? f.why_not_observable
                    : f.differs                   ? "set [" + f.line.section + "] " + f.line.key + " = " + f.line.value
                                                  : "consistent"});
  }
  std::vector<std::size_t> widths(4, 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::vector<std::string> lines;
  for (const auto& row : rows)
  {
    std::string line;
    for (std::size_t c = 0; c + 1 < row.size(); ++c) line += row[c] + std::string(widths[c] - row[c].size() + 2, ' ');
    line += row.back();
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}
}  // namespace mrpt_ext
