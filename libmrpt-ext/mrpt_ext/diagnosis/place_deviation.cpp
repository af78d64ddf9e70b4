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
}

std::vector<CalibrationFinding> placeDeviations(const std::vector<CalibrationFinding>& set,
                                                const SensorConfigs& sensors)
{
  std::map<std::string, double> squares;  // [m^2] of a section, both axes
  for (const CalibrationFinding& finding : set)
    if (finding.line.key == "lever_arm_x_m" || finding.line.key == "lever_arm_y_m")
      squares[finding.line.section] += square(finding.estimate - finding.configured);
  std::vector<CalibrationFinding> deviations;
  for (const auto& [section, sum] : squares)
  {
    const std::string label = section.substr(kSensorSection.size());
    if (configOf(sensors, label).lever_arm_std) continue;
    CalibrationFinding found{.what = label + ": deviation of stated places",
                             .unit = "m",
                             .configured = kAssumedLeverArmStd,
                             .estimate = std::min(std::sqrt(sum / 2), kAssumedLeverArmStd),
                             .std = std::min(std::sqrt(sum), kAssumedLeverArmStd) / 2,
                             .line = {section, "lever_arm_std_m", ""}};
    settleLine(found, true);
    deviations.push_back(found);
  }
  return deviations;
}
}  // namespace mrpt_ext
