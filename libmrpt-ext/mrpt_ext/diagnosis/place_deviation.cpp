#include "mrpt_ext/diagnosis/place_deviation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace mrpt_ext
{
namespace
{
const std::string kSensorSection = "Sensor_";
constexpr double kAssumedYawStd = 5;  // [deg]

/// What lines of one section correct: sum of squares.
using Corrections = std::map<std::string, double>;

CalibrationFinding leverArmDeviation(const std::string& label, double squares)
{
  return {.what = label + ": deviation of stated places",
          .unit = "m",
          .configured = kAssumedLeverArmStd,
          .estimate = std::min(std::sqrt(squares / 2), kAssumedLeverArmStd),
          .std = std::min(std::sqrt(squares), kAssumedLeverArmStd) / 2,
          .line = {kSensorSection + label, "lever_arm_std_m", ""}};
}

CalibrationFinding yawDeviation(const std::string& label, double squared)
{
  return {.what = label + ": deviation of stated directions",
          .unit = "deg",
          .configured = 0,
          .estimate = std::min(std::sqrt(squared / 2), kAssumedYawStd),
          .std = std::min(std::sqrt(squared), kAssumedYawStd) / 2,
          .decimals = 2,
          .line = {kSensorSection + label, "yaw_std_deg", ""}};
}
}  // namespace

bool isOfLeverArm(const CalibrationFinding& finding)
{
  return finding.line.key == "lever_arm_x_m" || finding.line.key == "lever_arm_y_m";
}

std::vector<CalibrationFinding> placeDeviations(const std::vector<CalibrationFinding>& set, const CalibrationData& data,
                                                const SensorConfigs& sensors)
{
  Corrections places, directions;  // [m^2] along both axes, [deg^2]; by label
  for (const CalibrationFinding& finding : set)
  {
    const double squared = square(finding.estimate - finding.configured);
    const auto own = [&] { return finding.line.section.substr(kSensorSection.size()); };
    if (isOfLeverArm(finding) && finding.differs) places[own()] += squared;
    if (finding.line.key == "bias_bearing_deg") directions[own()] += squared;
    if (finding.line.key == "odometry_yaw_deg")
      for (const std::string& label : sensorsWithBearings(data)) directions[label] += squared;
  }
  std::vector<CalibrationFinding> deviations;
  for (const auto& [label, squares] : places)
    if (!configOf(sensors, label).lever_arm_std) deviations.push_back(leverArmDeviation(label, squares));
  for (const auto& [label, squared] : directions)
    if (!configOf(sensors, label).yaw_std) deviations.push_back(yawDeviation(label, squared));
  for (CalibrationFinding& found : deviations) settleLine(found, true);
  return deviations;
}
}  // namespace mrpt_ext
