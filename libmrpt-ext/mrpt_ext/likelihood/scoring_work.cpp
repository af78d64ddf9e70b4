#include "mrpt_ext/likelihood/scoring_work.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/likelihood/sensor_tile.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kScoredTogether = SensorTile::kSize;  // robots: a tile; blocks that are not spread have several
constexpr double kCulledTogether = 8;                       // tiles
// Densities that take as long: one near the edge of the view, or of an uncertain landmark; telling whether a landmark
// is in view of a block, and whether near a detection.
constexpr double kCostAtEdge = 3, kCostOfCulling = 6, kCostOfNearness = 1.5;
constexpr double kLeastHalfGate = 0.1;  // [rad] of a detection and its landmark's direction from a compact block
constexpr double kLeastSide = 1e-3;     // [m] of the map
constexpr double kNearShare = 0.25;     // of the map: a landmark closer than that is seen in other directions

/// What the scorer works on: whole tiles.
double paddedSize(std::size_t robots)
{
  const std::size_t tiles = (robots + kScoredTogether - 1) / kScoredTogether;
  return static_cast<double>(tiles * kScoredTogether);
}

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

/// In densities.
struct Work
{
  double fixed = 0, of_detections = 0;  // the latter grows with their number
};

Work workOf(const Frame& frame, const LandmarkTable& map, const PoseBatch& robots)
{
  const double padded = paddedSize(robots.size());
  Work work;
  for (const Reading& reading : frame.readings)
  {
    const auto anonymous = static_cast<double>(anonymousCount(reading));
    work.of_detections += padded * (static_cast<double>(reading.detections.size()) - anonymous);
    if (anonymous == 0) continue;
    const bool limited = reading.model.max_range.has_value();
    const double compared = std::max(1.0, landmarksCompared(reading.model, map, robots));
    const double culled = static_cast<double>(map.size()) * padded / static_cast<double>(kScoredTogether) /
                          (limited ? 1 : kCulledTogether);
    work.of_detections += anonymous * (padded * compared * (limited ? kCostAtEdge : 1) + kCostOfNearness * culled);
    work.fixed += kCostOfCulling * culled;
  }
  return work;
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
  for (std::size_t first = 0; first < robots.size(); first += kScoredTogether)
  {
    const PoseBatch block = robots.block(first, std::min(kScoredTogether, robots.size() - first));
    const Vector2d extent(extentOf(block.x), extentOf(block.y));
    const double turn = extentOf(block.phi) + extent.norm() / near;
    const double in_direction = std::min(1.0, (turn + 2 * kLeastHalfGate) / kTwoPi);
    sum += shareInRange(model, map, extent) * in_direction * static_cast<double>(block.size());
  }
  return static_cast<double>(map.size()) * sum / static_cast<double>(robots.size());
}

double scoringWork(const Frame& frame, const LandmarkTable& map, const PoseBatch& robots)
{
  const Work work = workOf(frame, map, robots);
  return work.fixed + work.of_detections;
}

std::optional<Frame> affordableToScore(const Frame& frame, const LandmarkTable& map, const PoseBatch& robots,
                                       double most)
{
  // Nearly every frame can be scored whole, which the mere numbers tell.
  const double pairs = static_cast<double>(map.size()) * static_cast<double>(detectionCount(frame) + 1);
  if ((kCostAtEdge + 1) * pairs * paddedSize(robots.size()) <= most) return std::nullopt;
  const Work work = workOf(frame, map, robots);
  return affordableFrame(frame, work.of_detections, std::max(0.0, most - work.fixed));
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
