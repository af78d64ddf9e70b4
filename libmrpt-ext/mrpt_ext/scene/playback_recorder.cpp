#include "mrpt_ext/scene/playback_recorder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxSteps = 1000;
constexpr std::size_t kMaxParticles = 150000;  // in all
constexpr std::size_t kMaxParticlesPerStep = 300;
constexpr double kMinModeWeight = 0.01;

/// A range projected to the plane, where the height of the landmark is known.
template <typename Seen>
std::optional<double> planarRange(const Seen& sensor, int id, std::optional<double> range, const LandmarkTable& map)
{
  const auto index = map.indexOf(id);
  if (!range || sensor.horizontal_range || !index) return range;
  const double height = map[*index].position.z() - sensor.sensor_height;
  return std::sqrt(std::max(0.0, square(*range) - square(height)));
}

std::vector<DrawnDetection> drawnDetections(const Frame& frame, const LandmarkTable& map)
{
  std::vector<DrawnDetection> detections;
  for (const Reading& reading : frame.readings)
    for (const Detection& seen : reading.detections)
      detections.push_back(
          {reading.T_robot_sensor, seen.id, seen.bearing, planarRange(reading, seen.id, seen.range, map), false});
  for (const RunningFixReading& fix : frame.fixes)
    detections.push_back(
        {fix.T_robot_sensor, fix.id, fix.second_bearing, planarRange(fix, fix.id, fix.second_range, map), true});
  return detections;
}
}  // namespace

std::vector<Pose2> particlesByWeight(const ParticleSet& particles, std::size_t count)
{
  std::vector<Pose2> drawn;
  if (particles.size() <= count)
  {
    for (std::size_t i = 0; i < particles.size(); ++i) drawn.push_back(particles.pose(i));
    return drawn;
  }
  const std::vector<double> w = weights(particles);
  const double share = std::accumulate(w.begin(), w.end(), 0.0) / static_cast<double>(count);
  double sum = 0;
  for (std::size_t i = 0; i < particles.size() && drawn.size() < count; ++i)
    for (sum += w[i]; drawn.size() < count && (static_cast<double>(drawn.size()) + 0.5) * share <= sum;)
      drawn.push_back(particles.pose(i));
  return drawn;
}

PlaybackStep playbackStep(const Frame& frame, const FilterLocalizer* filter, const LandmarkTable& map,
                          std::size_t particles)
{
  PlaybackStep step{frame.time, {}, {}, drawnDetections(frame, map)};
  if (!filter) return step;
  step.particles = particlesByWeight(filter->particles(), particles);
  for (const Mode& mode : filter->lastStep().modes.modes)
    if (mode.weight >= kMinModeWeight) step.modes.push_back({mode.pose, mode.weight});
  return step;
}

PlaybackRecorder::PlaybackRecorder(std::size_t frames, const LandmarkTable& map)
    : map_(map),
      stride_(frames / (kMaxSteps + 1) + 1),
      particles_per_step_(std::min(kMaxParticlesPerStep, kMaxParticles / std::max<std::size_t>(frames / stride_, 1)))
{
}

void PlaybackRecorder::add(const Frame& frame, const FilterLocalizer* filter, std::vector<PlaybackStep>& playback)
{
  if (next_++ % stride_ != 0) return;
  playback.push_back(playbackStep(frame, filter, map_, particles_per_step_));
}
}  // namespace mrpt_ext
