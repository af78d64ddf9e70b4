#include "mrpt_ext/diagnosis/frame_window_check.h"

#include <algorithm>
#include <set>

#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
/// A radio that asks one anchor after the other gives readings of different landmarks: they belong together. Two
/// readings with a landmark in common do not, and neither do two scans without ids.
bool isRepeated(const Reading& first, const Reading& second)
{
  std::set<int> ids;
  for (const Detection& detection : first.detections) ids.insert(detection.id);
  const bool scans = first.detections.size() > 1 && second.detections.size() > 1;
  return std::any_of(second.detections.begin(), second.detections.end(),
                     [&](const Detection& detection)
                     { return ids.contains(detection.id) && (detection.id != kNoId || scans); });
}
}  // namespace

void FrameWindowCheck::add(const Frame& frame)
{
  std::map<std::string, const Reading*> last;
  std::set<std::string> joined;
  for (const Reading& reading : frame.readings)
  {
    if (reading.detections.empty()) continue;
    const Reading*& before = last[reading.sensor];
    if (before && reading.time > before->time && isRepeated(*before, reading))
    {
      Count& count = sensors_[reading.sensor];
      const double apart = reading.time - before->time;
      count.shortest = count.joined == 0 ? apart : std::min(count.shortest, apart);
      joined.insert(reading.sensor);
    }
    before = &reading;
  }
  for (const auto& [sensor, reading] : last) ++sensors_[sensor].frames;
  for (const std::string& sensor : joined) ++sensors_[sensor].joined;
}

std::vector<std::string> FrameWindowCheck::hints() const
{
  std::vector<std::string> hints;
  for (const auto& [sensor, count] : sensors_)
  {
    if (2 * count.joined < count.frames || count.joined == 0) continue;
    hints.push_back(sensor + ": " + std::to_string(count.joined) + " of " + std::to_string(count.frames) +
                    " frames join two of its readings, which are only " + fixedText(count.shortest, 3) +
                    " s apart: --set LocalizationExperiment.frame_window_s=" + fixedText(count.shortest / 2, 3));
  }
  return hints;
}
}  // namespace mrpt_ext
