#include "mrpt_ext/diagnosis/systematic_error_check.h"

#include <algorithm>

#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMatters = 1;  // standard deviations of the pose
constexpr const char* kCommand = ": see --diagnose, set it with --calibrate FILE.ini";

std::string withStd(double value, double std, int decimals)
{
  return fixedText(value, decimals) + " +- " + fixedText(std, decimals);
}

/// True for an offset or scale of ranges beside a height: they undo what was set or calibrated for want of the height.
bool followsFromHeight(const RegressedError& error, const std::vector<RegressedError>& errors)
{
  using enum CalibrationParameter;
  if (error.unknown.parameter != range_offset && error.unknown.parameter != range_scale) return false;
  return std::any_of(errors.begin(), errors.end(),
                     [&](const RegressedError& other)
                     {
                       return other.unknown.parameter == range_height && other.unknown.sensor == error.unknown.sensor &&
                              other.effect > kMatters;
                     });
}

/// `--diagnose` would take it for an offset and a scale, so it is not named.
std::string heightFinding(const RegressedError& error, const std::string& sensor)
{
  const std::string height = fixedText(std::sqrt(std::abs(error.value)), 1) + " m";
  if (error.value > 0)
    return sensor + ": ranges are too long, the more the nearer the landmark, as by a height of about " + height +
           " between sensor and landmarks that is not stated: check z in the map and of the sensor (sensors.csv)";
  return sensor + ": ranges are too short, the more the nearer the landmark, as if about " + height +
         " of the stated height between sensor and landmarks were none: check z in the map and of the sensor "
         "(sensors.csv); a sensor that measures in the plane has the z of the landmarks";
}

/// What `error` means for the reader, and what to do; its size without sign where the words tell the sign.
std::string finding(const RegressedError& error, const std::string& sensor)
{
  const double size = std::abs(error.value);
  const bool positive = error.value > 0;
  const auto percent = [&] { return withStd(100 * size, 100 * error.std, 1) + " %"; };
  switch (error.unknown.parameter)
  {
    case CalibrationParameter::bearing_offset:
      return sensor + ": bearings are " + withStd(radToDeg(size), radToDeg(error.std), 2) + " deg too " +
             (positive ? "large" : "small") + " (offset)" + kCommand;
    case CalibrationParameter::range_offset:
      return sensor + ": ranges are " + withStd(size, error.std, 3) + " m too " + (positive ? "long" : "short") +
             " (offset)" + kCommand;
    case CalibrationParameter::range_scale:
      return sensor + ": ranges are " + percent() + " too " + (positive ? "long" : "short") +
             " (scale: innovations grow with distance)" + kCommand;
    case CalibrationParameter::range_height:
      return heightFinding(error, sensor);
    case CalibrationParameter::distance_scale:
      return "odometry: distances are " + percent() + " too " + (positive ? "short" : "long") + kCommand;
    case CalibrationParameter::rotation_scale:
      return "odometry: turns are " + percent() + " too " + (positive ? "small" : "large") + kCommand;
    case CalibrationParameter::veer:
      return "odometry: it does not see a turn of " + withStd(radToDeg(size), radToDeg(error.std), 2) +
             " deg per metre to the " + (positive ? "left" : "right") + kCommand;
    case CalibrationParameter::drift:
      return "odometry: it does not see a turn of " + withStd(radToDeg(size), radToDeg(error.std), 3) +
             " deg per second to the " + (positive ? "left" : "right") + ", also at standstill" + kCommand;
    case CalibrationParameter::delay:
      break;  // see delayHint()
    case CalibrationParameter::lever_arm_x:
    case CalibrationParameter::lever_arm_y:
    case CalibrationParameter::bearing_scale:
    case CalibrationParameter::range_axis:
    case CalibrationParameter::distance_per_turn:
    case CalibrationParameter::pivot_scale:
    case CalibrationParameter::landmark_offset:
    case CalibrationParameter::landmark_x:
    case CalibrationParameter::landmark_y:
      break;  // not among the errors that are looked for in every run
  }
  return {};
}
}  // namespace

std::string delayHint(const std::optional<DelayFinding>& finding, const std::vector<std::string>& sensors)
{
  if (!finding || !(finding->effect > kMatters)) return {};
  const std::string subject = sensors.size() == 1 ? sensors.front() + ": detections" : "detections";
  return subject + " are about " + fixedText(std::abs(finding->delay), 2) + " s " +
         (finding->delay > 0 ? "older" : "younger") +
         " than odometry at their stamps (delay: innovations grow with speed)" + kCommand;
}

std::vector<std::string> systematicErrorHints(const std::vector<RegressedError>& errors,
                                              const std::vector<std::string>& sensors)
{
  std::vector<std::string> hints;
  for (const RegressedError& error : errors)
    if (error.effect > kMatters && !followsFromHeight(error, errors))
      hints.push_back(finding(error, isOfOdometry(error.unknown.parameter) ? "" : sensors[error.unknown.sensor]));
  return hints;
}
}  // namespace mrpt_ext
