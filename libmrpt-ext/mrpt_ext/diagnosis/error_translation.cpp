#include "mrpt_ext/diagnosis/error_translation.h"

#include "mrpt_ext/configuration/bias_config.h"

namespace mrpt_ext
{
namespace
{
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
    case CalibrationParameter::bearing_scale:
    case CalibrationParameter::range_axis:
      return "bearings too much alike";
    case CalibrationParameter::range_offset:
    case CalibrationParameter::range_scale:
      return "too few different ranges";
    case CalibrationParameter::rotation_scale:
      return "too few turns";
    case CalibrationParameter::pivot_scale:
      return "too few turns in place";
    case CalibrationParameter::distance_per_turn:
      return "too few turns while driving, or no straight ways";
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
  Translator(const CalibrationResult& errors, const CalibrationData& data, const LocalizationConfig& config)
      : errors_(errors), sensors_(data.sensors), commanded_(data.commanded), config_(config)
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
    using enum CalibrationParameter;
    const OdometryCorrection& now = config_.frames.odometry;
    const double turns = 1 + valueOf(rotation_scale), degree = degToRad(1.0);
    CalibrationFinding found;
    switch (error.unknown.parameter)
    {
      case distance_scale:
        found = {.what = "odometry: true over measured distance", .decimals = 4};
        found.line = {kMotion, "odometry_scale", ""};
        set(found, error, now.scale, now.scale);
        if (setAsMean(found, error, BiasKind::distance_scale, "")) found.what = "odometry: relative error of distance";
        return found;
      case distance_per_turn:
        found = {.what = "odometry: unmeasured distance per degree turned while driving", .unit = "m", .decimals = 5};
        found.line = {kMotion, "odometry_distance_per_deg_m", ""};
        // The configured value adds to the uncorrected distance, per uncorrected turn.
        set(found, error, degree * now.distance_per_turn, degree * now.rotation_scale / now.scale);
        return found;
      case rotation_scale:
        found = {.what = "odometry: true over measured rotation", .decimals = 4};
        found.line = {kMotion, "odometry_rotation_scale", ""};
        set(found, error, now.rotation_scale, now.rotation_scale);
        if (setAsMean(found, error, BiasKind::rotation_scale, "")) found.what = "odometry: relative error of rotation";
        return found;
      case pivot_scale:
        found = {.what = "odometry: turns in place, beside others", .decimals = 4};
        found.line = {kMotion, "odometry_pivot_scale", ""};
        set(found, error, now.pivot_scale, now.pivot_scale / turns);
        return found;
      case veer:
        found = {.what = "odometry: unmeasured left turn per metre", .unit = "deg", .decimals = 2};
        found.line = {kMotion, "odometry_turn_per_m_deg", ""};
        // The configured value scales with the rotations, and is per metre of the uncorrected distance.
        set(found, error, now.turn_per_m * turns / (1 + valueOf(distance_scale)) / degree, 1 / degree);
        found.configured = now.turn_per_m / degree;
        return found;
      default:
        found = {.what = "odometry: unmeasured left turn per second", .unit = "deg/s", .decimals = 3};
        found.line = {kMotion, "odometry_turn_per_s_deg", ""};
        set(found, error, now.turn_per_s * turns / degree, 1 / degree);
        found.configured = now.turn_per_s / degree;
        return found;
    }
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
      case CalibrationParameter::bearing_scale:
        found = {.what = label + ": measured over true bearing", .decimals = 4, .line = {section, "scale_bearing", ""}};
        set(found, error, now.scale_bearing, now.scale_bearing);
        return found;
      case CalibrationParameter::range_axis:
        found = {.what = label + ": axis of depths further left",
                 .unit = "deg",
                 .decimals = 2,
                 .line = {section, "range_axis_deg", ""}};
        set(found, error, radToDeg(now.range_axis), radToDeg(1.0));
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
    const bool odometry_is_late = (commanded_ || config_.frames.odometry.delay != 0) && sensors_.size() == 1;
    CalibrationFinding found{.what = odometry_is_late ? "odometry: latency" : label + ": delay against odometry",
                             .unit = "s",
                             .line = odometry_is_late ? IniAssignment{kMotion, "odometry_delay_s", ""}
                                                      : IniAssignment{"Sensor_" + label, "delay_s", ""}};
    set(found, error, odometry_is_late ? config_.frames.odometry.delay : now.delay, 1);
    return found;
  }

  const CalibrationResult& errors_;
  const std::vector<std::string>& sensors_;
  bool commanded_;
  const LocalizationConfig& config_;
};
}  // namespace

CalibrationFinding findingOf(const ParameterEstimate& error, const CalibrationResult& errors,
                             const CalibrationData& data, const LocalizationConfig& config)
{
  return Translator(errors, data, config).finding(error);
}
}  // namespace mrpt_ext
