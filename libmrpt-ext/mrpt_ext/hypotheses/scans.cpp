#include "mrpt_ext/hypotheses/scans.h"

#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/likelihood/missed_detections.h"

namespace mrpt_ext
{
std::vector<Scan> scansOf(std::span<const Reading> readings, const LandmarkTable& map, const LandmarkIndex& index)
{
  std::vector<Scan> scans;
  for (const Reading& reading : readings)
  {
    Scan scan{reading.T_robot_sensor, reading.model, {}};
    if (!scoresMissedDetections(reading)) scan.model.detection_probability.reset();
    for (const LandmarkMeasurement& m : anonymousMeasurements({&reading, 1}, map))
      scan.detections.push_back({m.bearing, m.range, m.std_bearing, m.std_range, index.categoryOf(m.category)});
    if (!scan.detections.empty()) scans.push_back(std::move(scan));
  }
  return scans;
}
}  // namespace mrpt_ext
