#include "mrpt_ext/likelihood/scoring_work.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kBlock = 128;     // robots; a block of the scorer is a few times larger unless it is spread
constexpr double kLeastHalfGate = 0.1;  // [rad] of a detection and its landmark's direction from a compact block
constexpr double kLeastSide = 1e-3;     // [m] of the map
constexpr double kNearShare = 0.25;     // of the map: a landmark closer than that is seen in other directions

double extentOf(std::span<const float> column)
{
  const auto [low, high] = std::minmax_element(column.begin(), column.end());
  return double{*high} - double{*low};
}

std::size_t anonymousCount(const Reading& reading)
{
  return static_cast<std::size_t>(std::count_if(reading.detections.begin(), reading.detections.end(),
                                                [](const Detection& d) { return d.id == kNoId; }));
}
}  // namespace

double shareInRange(const SensorModel& model, const LandmarkTable& map, const Vector2d& extent)
{
  if (!model.max_range || map.empty()) return 1;
  const auto [low, high] = map.boundingBox();
  const Vector2d side = (high - low).cwiseMax(kLeastSide);
  return ((extent.array() + 2 * *model.max_range) / side.array()).min(1.0).prod();
}

double landmarksCompared(const SensorModel& model, const LandmarkTable& map, const PoseBatch& robots)
{
  if (map.empty() || robots.size() == 0) return 0;
  const auto [low, high] = map.boundingBox();
  const double near = kNearShare * (high - low).cwiseMax(kLeastSide).norm();
  double sum = 0;
  for (std::size_t first = 0; first < robots.size(); first += kBlock)
  {
    const PoseBatch block = robots.block(first, std::min(kBlock, robots.size() - first));
    const Vector2d extent(extentOf(block.x), extentOf(block.y));
    const double turn = extentOf(block.phi) + extent.norm() / near;
    const double in_direction = std::min(1.0, (turn + 2 * kLeastHalfGate) / kTwoPi);
    sum += shareInRange(model, map, extent) * in_direction * static_cast<double>(block.size());
  }
  return static_cast<double>(map.size()) * sum / static_cast<double>(robots.size());
}

double scoringWork(const Frame& frame, const LandmarkTable& map, const PoseBatch& robots)
{
  double densities = 0;
  for (const Reading& reading : frame.readings)
  {
    const std::size_t anonymous = anonymousCount(reading);
    densities += static_cast<double>(reading.detections.size() - anonymous);
    if (anonymous > 0)
      densities += static_cast<double>(anonymous) * std::max(1.0, landmarksCompared(reading.model, map, robots));
  }
  return densities * static_cast<double>(robots.size());
}

std::optional<Frame> affordableToScore(const Frame& frame, const LandmarkTable& map, const PoseBatch& robots,
                                       double most)
{
  // Nearly every frame can be scored whole, which the mere numbers tell.
  if (static_cast<double>(map.size() * robots.size() * detectionCount(frame)) <= most) return std::nullopt;
  return affordableFrame(frame, scoringWork(frame, map, robots), most);
}

std::size_t affordableRobots(const Frame& frame, const LandmarkTable& map, const PoseBatch& robots,
                             std::size_t detections, double most)
{
  const double count = std::max(1.0, static_cast<double>(detectionCount(frame)));
  const double densities = scoringWork(frame, map, robots) * std::min(1.0, static_cast<double>(detections) / count);
  if (densities <= most) return robots.size();
  return static_cast<std::size_t>(static_cast<double>(robots.size()) * most / densities);
}
}  // namespace mrpt_ext
