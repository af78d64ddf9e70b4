#include "mrpt_ext/likelihood/missed_detections.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr double kUniformShare = 0.01;  // share of the uniform part: visibility is never known better than this

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
    if (map[j].id != kNoId || reading.detections.empty())  // where nothing is seen, anonymous ones are missed too
      log_probability +=
          std::log(reportProbability(detection_probability * predictions[j].visibility, isReported(reading, map[j])));
  return log_probability;
}

double logCount(const Reading& reading, std::span<const LandmarkPrediction> predictions)
{
  const double detection_probability = *reading.model.detection_probability;
  const CountModel model = countModel(reading, predictions.size());
  double mean = model.expected_clutter, variance = model.extra_variance;
  for (const LandmarkPrediction& prediction : predictions)
  {
    const double p = detection_probability * prediction.visibility;
    mean += p;
    variance += p * (1 - p);
  }
  const double gaussian = std::exp(-0.5 * square(model.count - mean) / variance) / std::sqrt(kTwoPi * variance);
  return std::log(model.gaussian_share * gaussian + model.uniform);
}
}  // namespace

bool areIdentified(const Reading& reading)
{
  return std::all_of(reading.detections.begin(), reading.detections.end(),
                     [](const Detection& detection) { return detection.id != kNoId; });
}

double reportProbability(double probability, bool reported)
{
  const double p = kUniformShare / 2 + (1 - kUniformShare) * probability;
  return reported ? p : 1 - p;
}

CountModel countModel(const Reading& reading, std::size_t landmarks)
{
  const double count = static_cast<double>(reading.detections.size());
  const double clutter = count * std::min(reading.model.clutter_probability, 0.99);
  return {.count = count,
          .expected_clutter = clutter,
          .extra_variance = clutter + 0.25,  // the quarter stands for the rounding to whole counts
          .gaussian_share = 1 - kUniformShare,
          .uniform = kUniformShare / (1.0 + static_cast<double>(landmarks))};
}

bool scoresMissedDetections(const Reading& reading)
{
  return reading.model.detection_probability && reading.model.max_range && reading.model.has_field_of_view;
}

double logMissedDetections(const Reading& reading, const LandmarkTable& map,
                           std::span<const LandmarkPrediction> predictions)
{
  return areIdentified(reading) ? logIdentified(reading, map, predictions) : logCount(reading, predictions);
}
}  // namespace mrpt_ext
