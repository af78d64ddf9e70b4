#include "mrpt_ext/diagnosis/systematic_error_check.h"

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

/// What `error` means for the reader; its size without sign where the words tell the sign.
std::string finding(const RegressedError& error, const std::string& sensor)
{
  const double size = std::abs(error.value);
  const bool positive = error.value > 0;
  const auto percent = [&] { return withStd(100 * size, 100 * error.std, 1) + " %"; };
  switch (error.unknown.parameter)
  {
    case CalibrationParameter::bearing_offset:
      return sensor + ": bearings are " + withStd(radToDeg(size), radToDeg(error.std), 2) + " deg too " +
             (positive ? "large" : "small") + " (offset)";
    case CalibrationParameter::range_offset:
      return sensor + ": ranges are " + withStd(size, error.std, 3) + " m too " + (positive ? "long" : "short") +
             " (offset)";
    case CalibrationParameter::range_scale:
      return sensor + ": ranges are " + percent() + " too " + (positive ? "long" : "short") +
             " (scale: innovations grow with distance)";
    case CalibrationParameter::distance_scale:
      return "odometry: distances are " + percent() + " too " + (positive ? "short" : "long");
    case CalibrationParameter::rotation_scale:
      return "odometry: turns are " + percent() + " too " + (positive ? "small" : "large");
    case CalibrationParameter::veer:
      return "odometry: it does not see a turn of " + withStd(radToDeg(size), radToDeg(error.std), 2) +
             " deg per metre to the " + (positive ? "left" : "right");
    case CalibrationParameter::delay:
      break;  // see delayHint()
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
    if (error.effect > kMatters)
      hints.push_back(finding(error, isOfOdometry(error.unknown.parameter) ? "" : sensors[error.unknown.sensor]) +
                      kCommand);
  return hints;
}
}  // namespace mrpt_ext
