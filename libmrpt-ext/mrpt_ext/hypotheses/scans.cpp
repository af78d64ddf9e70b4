#include "mrpt_ext/hypotheses/scans.h"

#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/likelihood/missed_detections.h"

namespace mrpt_ext
{
std::vector<Scan> scansOf(std::span<const Reading> readings, const LandmarkTable& map, const LandmarkIndex& index)
{
  std::vector<Scan> places;
  for (const Reading& reading : readings)
  {
    Scan place{reading.T_robot_sensor, reading.model, {}};
    if (!scoresMissedDetections(reading)) place.model.detection_probability.reset();
    for (const LandmarkMeasurement& s : unidentifiedSightings({&reading, 1}, map))
      place.detections.push_back({s.bearing, s.range, s.std_bearing, s.std_range, index.categoryOf(s.category)});
    if (!place.detections.empty()) places.push_back(std::move(place));
  }
  return places;
}
}  // namespace mrpt_ext
