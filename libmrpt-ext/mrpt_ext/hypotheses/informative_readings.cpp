#include "mrpt_ext/hypotheses/informative_readings.h"

#include <algorithm>
#include <map>

namespace mrpt_ext
{
std::vector<Reading> informativeReadings(std::span<const Reading> oldest_first)
{
  std::size_t detections = 0;
  std::map<std::string, std::size_t> count, seen;
  for (const Reading& reading : oldest_first)
  {
    detections += reading.detections.size();
    ++count[reading.sensor];
  }
  const std::size_t excess = std::max<std::size_t>(1, (detections + kMostJoinedDetections - 1) / kMostJoinedDetections);
  std::vector<Reading> chosen;
  for (const Reading& reading : oldest_first)
  {
    const std::size_t of_sensor = count[reading.sensor];
    const std::size_t wanted = std::max(of_sensor / excess, std::min(of_sensor, kLeastJoinedReadings));
    const std::size_t kept = std::min(wanted, kMostJoinedReadings), position = ++seen[reading.sensor];
    // The n-th of them is kept where n * kept / of_sensor steps to the next whole number, as it does at the last one.
    if (position * kept / of_sensor != (position - 1) * kept / of_sensor) chosen.push_back(reading);
  }
  return chosen;
}
}  // namespace mrpt_ext
