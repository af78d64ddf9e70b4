#include "mrpt_ext/correspondence/match_evidence.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
/// `peak`: density of a measurement where it should be; `volume`: of the space a false one is spread over.
double logEvidence(const SensorPlace& place, double peak, double volume, double in_view)
{
  const double clutter = std::max(place.model.clutter_probability, 1e-6);
  const double count = static_cast<double>(place.detections.size());
  const double p = std::min(place.model.detection_probability.value_or(0.5), 0.99);
  const double odds = place.model.detection_probability ? p / (1 - p) / count : 1 / std::max(1.0, in_view);
  return std::log(1 + odds * peak * volume / clutter) - 0.5;
}
}  // namespace

double logEvidencePerBearing(const SensorPlace& place, double std_bearing, double in_view)
{
  return logEvidence(place, 1 / (std::sqrt(kTwoPi) * std_bearing), kTwoPi, in_view);
}

double logEvidencePerPoint(const SensorPlace& place, const LandmarkIndex& map)
{
  double spread = 0, count = 0;
  for (const UnidentifiedDetection& d : place.detections)
    if (d.bearing && d.range)
    {
      spread += d.std_bearing * d.std_range;
      count += 1;
    }
  if (!(count > 0)) return 0;
  const double farthest = place.model.max_range.value_or(std::max(1.0, 1.5 * (map.high() - map.low()).norm()));
  return logEvidence(place, count / (kTwoPi * spread), kTwoPi * farthest, static_cast<double>(map.size()));
}
}  // namespace mrpt_ext
