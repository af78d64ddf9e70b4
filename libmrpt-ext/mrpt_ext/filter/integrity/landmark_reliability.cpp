#include "mrpt_ext/filter/integrity/landmark_reliability.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/integrity/sensor_monitors.h"
#include "mrpt_ext/filter/particles/spaced_draws.h"
#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostDraws = 64;  // from the posterior: a probability to a few per cent
constexpr std::size_t kLeastDraws = 4;
constexpr std::size_t kParticlesPerDraw = 8;          // at least: where few particles do, the mode is narrow
constexpr std::size_t kMostPairsOfDraws = 8'000'000;  // of a detection and a landmark, over all draws
constexpr std::uint64_t kCostOfPair = 12;             // operations
constexpr double kMaxClutter = 0.7;                   // a landmark is never trusted less

void addResidual(LandmarkHistory& history, double residual, double variance, double weight)
{
  const double normalised = residual / std::sqrt(variance);
  history.residual_weight += weight;
  history.residual_sum += weight * normalised;
  history.residual_sum2 += weight * normalised * normalised;
}

void addResiduals(LandmarkHistory& history, const Detection& detection, const LandmarkPrediction& prediction,
                  double weight)
{
  if (detection.bearing)
    addResidual(history, wrap(*detection.bearing - prediction.bearing),
                square(detection.std_bearing) + prediction.bearing_variance, weight);
  if (detection.range)
    addResidual(history, *detection.range - prediction.range, square(detection.std_range) + prediction.range_variance,
                weight);
}
}  // namespace

LandmarkClutter LandmarkReliability::clutter(double sensor_clutter) const
{
  LandmarkClutter result(histories_.size());
  for (std::size_t j = 0; j < histories_.size(); ++j)
  {
    const LandmarkHistory& history = histories_[j];
    const double share =
        (prior_strength_ * sensor_clutter + history.false_identified) / (prior_strength_ + history.identified);
    result[j] = std::min(share, std::max(kMaxClutter, sensor_clutter));
  }
  return result;
}

LandmarkClutter LandmarkReliability::clutter(const Reading& reading) const
{
  return memory_.predict(sensorKey(reading), reading.time, clutter(reading.model.clutter_probability));
}

void LandmarkReliability::remember(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& shares,
                                   const std::vector<double>& outliers)
{
  const std::string sensor = sensorKey(reading);
  for (std::size_t d = 0; d < reading.detections.size(); ++d)
    if (const auto landmark = map.indexOf(reading.detections[d].id))
      memory_.observe(sensor, reading.time, *landmark, {outliers[d], shares[*landmark]});
}

double LandmarkReliability::observe(const Reading& reading, const LandmarkTable& map, const ParticleSet& particles,
                                    bool learn, unsigned threads)
{
  const std::size_t pairs = std::max<std::size_t>(1, reading.detections.size() * map.size());
  const std::size_t most = std::clamp(particles.size() / kParticlesPerDraw, kLeastDraws, kMostDraws);
  const std::size_t wanted = std::clamp(kMostPairsOfDraws / pairs, kLeastDraws, most);
  const std::vector<std::size_t> draws = spacedDraws(particles, wanted, threads);
  if (draws.empty() || reading.detections.empty()) return 0;
  WorkCounter::add(kCostOfPair * pairs * draws.size());
  const LandmarkClutter current = clutter(reading.model.clutter_probability);
  std::vector<double> outliers(reading.detections.size(), 1.0);  // probabilities
  const double share = 1.0 / static_cast<double>(draws.size());
  const PoseBatch poses = particles.poses();
  double inliers = 0;
  for (const std::size_t draw : draws)
  {
    const Pose2 robot = particles.pose(draw);
    const SensorBias bias = sensorBias(poses, draw, reading.sensor);
    const auto probabilities = associationProbabilities(reading, map, current, robot, bias);
    for (std::size_t d = 0; d < probabilities.size(); ++d)
      for (std::size_t j = 0; j < map.size(); ++j)
      {
        const double p = probabilities[d][j];
        const Detection& detection = reading.detections[d];
        const bool identified = detection.id != kNoId && detection.id == map[j].id;
        inliers += share * p;
        outliers[d] -= share * p;
        if (!learn) continue;
        histories_[j].seen += share * (identified ? 1.0 : p);
        histories_[j].associated += share * p;
        histories_[j].identified += identified ? share : 0.0;
        histories_[j].false_identified += identified ? share * (1 - p) : 0.0;
        if (!(p > 0.01)) continue;
        LandmarkPrediction prediction = predict(map[j], reading, robot);
        applyBias(prediction, bias);
        addResiduals(histories_[j], detection, prediction, share * p);
      }
  }
  if (learn) remember(reading, map, current, outliers);
  return inliers / static_cast<double>(reading.detections.size());
}
}  // namespace mrpt_ext
