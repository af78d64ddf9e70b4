#include "mrpt_ext/likelihood/missed_detections.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr double kSurprise = 0.01;  // share of the uniform part: visibility is never known better than this

double logReported(double probability, bool reported)
{
  const double p = kSurprise / 2 + (1 - kSurprise) * probability;
  return std::log(reported ? p : 1 - p);
}

bool isReported(const Reading& reading, const Landmark& landmark)
{
  return std::any_of(reading.detections.begin(), reading.detections.end(),
                     [&](const Detection& detection) { return detection.id == landmark.id; });
}

double logIdentified(const Reading& reading, const LandmarkTable& map, std::span<const LandmarkPrediction> predictions)
{
  const double detection_probability = *reading.model.detection_probability;
  double log_probability = 0;
  for (std::size_t j = 0; j < map.size(); ++j)
    if (map[j].id != kNoId || reading.detections.empty())  // where nothing is seen, nameless ones are missed too
      log_probability += logReported(detection_probability * predictions[j].chance, isReported(reading, map[j]));
  return log_probability;
}

double logCount(const Reading& reading, std::span<const LandmarkPrediction> predictions)
{
  const double detection_probability = *reading.model.detection_probability;
  const double clutter = std::min(reading.model.clutter_probability, 0.99);
  double mean = 0, variance = 0;
  for (const LandmarkPrediction& prediction : predictions)
  {
    const double p = detection_probability * prediction.chance;
    mean += p;
    variance += p * (1 - p);
  }
  const double count = static_cast<double>(reading.detections.size());
  const double expected_clutter = count * clutter;
  mean += expected_clutter;
  variance += expected_clutter + 0.25;  // the quarter stands for the rounding to whole counts
  const double gaussian = std::exp(-0.5 * square(count - mean) / variance) / std::sqrt(kTwoPi * variance);
  return std::log((1 - kSurprise) * gaussian + kSurprise / (1.0 + static_cast<double>(predictions.size())));
}
}  // namespace

bool scoresMissedDetections(const Reading& reading)
{
  return reading.model.detection_probability && reading.model.max_range && reading.model.has_field_of_view;
}

double logMissedDetections(const Reading& reading, const LandmarkTable& map,
                           std::span<const LandmarkPrediction> predictions)
{
  const bool identified = std::all_of(reading.detections.begin(), reading.detections.end(),
                                      [](const Detection& detection) { return detection.id != kNoId; });
  return identified ? logIdentified(reading, map, predictions) : logCount(reading, predictions);
}
}  // namespace mrpt_ext
