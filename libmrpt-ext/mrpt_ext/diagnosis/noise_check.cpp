#include "mrpt_ext/diagnosis/noise_check.h"

#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSignificantShare = 5;    // standard errors
constexpr double kRatio = 1.5;             // found over declared, below which nothing is gained
constexpr double kLeastInnovations = 200;  // of a sensor

void addScatter(std::vector<std::string>& hints, const std::string& sensor, const InnovationStatistics& statistics,
                bool is_range)
{
  if (statistics.count() < kLeastInnovations || statistics.scatter() < kRatio) return;
  hints.push_back(sensor + ": " + (is_range ? "ranges" : "bearings") + " are off by " +
                  fixedText(statistics.scatter(), 1) +
                  " times their declared standard deviation: --diagnose tells whether " +
                  (is_range ? "std_range_m" : "std_bearing_deg") + " or the noise in [MotionModel] is too small");
}
}  // namespace

std::vector<std::string> noiseHints(const std::map<std::string, SensorInnovations>& sensors)
{
  std::vector<std::string> hints;
  for (const auto& [label, sensor] : sensors)
  {
    const double share = sensor.detections.share(), declared = sensor.clutter_probability;
    if (share > kRatio * declared && share - declared > kSignificantShare * sensor.detections.shareStd())
      hints.push_back(label + ": " + fixedText(100 * share, 0) +
                      " % of the detections agree with no landmark, declared are " + fixedText(100 * declared, 0) +
                      " %: --set Sensor_" + label + ".clutter_probability=" + fixedText(share, 2) +
                      ", or see --diagnose");
    addScatter(hints, label, sensor.bearings, false);
    addScatter(hints, label, sensor.ranges, true);
  }
  return hints;
}
}  // namespace mrpt_ext
