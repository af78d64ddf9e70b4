#include "mrpt_ext/filter/integrity/missed_landmarks.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/particles/spaced_draws.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/sensor_bias.h"

namespace mrpt_ext
{
namespace
{
constexpr double kGateOfMiss = 3;      // standard deviations
constexpr double kLeastInView = 0.01;  // visibility of a landmark that is looked for
constexpr double kPriorReadings = 1;   // that the declared detection probability is worth
constexpr double kUndeclaredDetection = 0.5;
constexpr double kMostDetection = 0.99;  // no detection is certain

/// A landmark in view of one draw.
struct Expected
{
  std::size_t landmark;
  double visibility;
  bool seen;
};

std::vector<Expected> expectedFrom(const Pose2& robot, const SensorBias& bias, const Reading& reading,
                                   const LandmarkTable& map)
{
  std::vector<Expected> result;
  for (std::size_t j = 0; j < map.size(); ++j)
  {
    LandmarkPrediction prediction = predict(map[j], reading, robot);
    if (prediction.visibility < kLeastInView) continue;
    applyBias(prediction, bias);
    const bool seen = std::any_of(reading.detections.begin(), reading.detections.end(),
                                  [&](const Detection& detection) {
                                    return mayShow(detection, map[j]) && isWithin(detection, prediction, kGateOfMiss);
                                  });
    result.push_back({j, prediction.visibility, seen});
  }
  return result;
}
}  // namespace

double MissedLandmarks::count(const Reading& reading, const LandmarkTable& map, const ParticleSet& particles)
{
  const std::vector<std::size_t> draws = spacedDraws(particles, draws_);
  if (draws.empty() || reading.detections.empty()) return 0;
  const double share = 1 / static_cast<double>(draws.size());
  const double declared = std::min(reading.model.detection_probability.value_or(kUndeclaredDetection), kMostDetection);
  const PoseBatch poses = particles.poses();
  std::vector<History> now(histories_.size());
  std::vector<double> log_missed_by_draw;
  for (const std::size_t draw : draws)
  {
    double log_missed = 0;
    for (const Expected& expected :
         expectedFrom(particles.pose(draw), sensorBias(poses, draw, reading.sensor), reading, map))
    {
      const double in_view = share * expected.visibility;
      (expected.seen ? now[expected.landmark].seen : now[expected.landmark].missed) += in_view;
      if (expected.seen) continue;
      const History& history = histories_[expected.landmark];
      const double p = (kPriorReadings * declared + history.seen) / (kPriorReadings + history.seen + history.missed);
      const double never_seen = std::max(0.0, 1 - history.seen);
      log_missed += never_seen * std::log(1 - std::min(p, declared) * expected.visibility);
    }
    log_missed_by_draw.push_back(log_missed);
  }
  for (std::size_t j = 0; j < now.size(); ++j)
  {
    histories_[j].seen += now[j].seen;
    histories_[j].missed += now[j].missed;
  }
  const double most = *std::max_element(log_missed_by_draw.begin(), log_missed_by_draw.end());
  double likelihood = 0;  // relative to the most likely draw, so that it is never zero
  for (const double log_missed : log_missed_by_draw) likelihood += share * std::exp(log_missed - most);
  return most + std::log(likelihood);
}
}  // namespace mrpt_ext
