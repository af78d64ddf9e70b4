#include "mrpt_ext/filter/landmark_reliability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "mrpt_ext/filter/weight_kernels.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kSamples = 64;  // draws from the posterior: enough for a probability to a few per cent

/// Evenly spaced draws from the posterior; deterministic, so that learning costs no random numbers.
std::vector<std::size_t> spacedDraws(const ParticleSet& particles)
{
  constexpr std::size_t kChunk = 1024;
  std::vector<std::size_t> draws;
  double cumulative = 0;
  const auto wanted = [&] { return (static_cast<double>(draws.size()) + 0.5) / kSamples; };
  std::array<float, kChunk> weight;
  for (std::size_t first = 0; first < particles.size(); first += kChunk)
  {
    const std::size_t count = std::min(kChunk, particles.size() - first);
    const double sum =
        exponentials(std::span(particles.log_weight).subspan(first, count), 0, std::span(weight).first(count));
    double reached = cumulative;
    for (std::size_t i = 0; i < count && draws.size() < kSamples && wanted() < cumulative + sum; ++i)
    {
      reached += double{weight[i]};
      while (draws.size() < kSamples && wanted() < reached) draws.push_back(first + i);
    }
    cumulative += sum;
  }
  if (draws.empty() && !particles.empty()) draws.push_back(0);
  return draws;
}

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
    const double share = (prior_strength_ * sensor_clutter + history.false_named) / (prior_strength_ + history.named);
    result[j] = std::min(share, std::max(max_clutter_, sensor_clutter));
  }
  return result;
}

double LandmarkReliability::observe(const Reading& reading, const LandmarkTable& map, const ParticleSet& particles,
                                    bool learn)
{
  const std::vector<std::size_t> draws = spacedDraws(particles);
  if (draws.empty() || reading.detections.empty()) return 0;
  const LandmarkClutter current = clutter(reading.model.clutter_probability);
  const double share = 1.0 / static_cast<double>(draws.size());
  const PoseBatch poses = particles.poses();
  double explained = 0;
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
        const bool named = detection.id != kNoId && detection.id == map[j].id;
        explained += share * p;
        if (!learn) continue;
        histories_[j].seen += share * (named ? 1.0 : p);
        histories_[j].associated += share * p;
        histories_[j].named += named ? share : 0.0;
        histories_[j].false_named += named ? share * (1 - p) : 0.0;
        if (!(p > 0.01)) continue;
        LandmarkPrediction prediction = predict(map[j], reading, robot);
        applyBias(prediction, bias);
        addResiduals(histories_[j], detection, prediction, share * p);
      }
  }
  return explained / static_cast<double>(reading.detections.size());
}
}  // namespace mrpt_ext
