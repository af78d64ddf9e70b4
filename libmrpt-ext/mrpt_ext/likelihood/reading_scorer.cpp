#include "mrpt_ext/likelihood/reading_scorer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/missed_detections.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kBlockTiles = 8;  // share one update at the map
constexpr std::size_t kTile = SensorTile::kSize;

bool isIdentified(const Detection& detection) { return detection.id != kNoId; }
}  // namespace

struct ReadingScorer::BlockTerms
{
  std::vector<SensorTile> tiles = std::vector<SensorTile>(kBlockTiles);
  std::optional<LandmarkCulling> culling;
  AnonymousScorer::Terms anonymous;
  MissedScorer::Terms missed;
};

ReadingScorer::ReadingScorer(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& clutter,
                             const Vector2d& origin)
    : reading_(reading),
      map_(map),
      clutter_(clutter),
      frame_(reading, origin),
      default_max_range_(defaultMaxRange(map)),
      anonymous_(reading, map, clutter, frame_, default_max_range_)
{
  for (const Detection& detection : reading.detections)
  {
    const double volume = measurementVolume(detection, reading.model, default_max_range_);
    const auto known = map.indexOf(detection.id);
    if (known)
      addIdentified(detection, *known, volume);
    else if (isIdentified(detection) || !mayShowAny(detection, map))
      constant_ -= std::log(volume);  // it can only be clutter
  }
  if (scoresMissedDetections(reading)) missed_.emplace(reading, map, frame_);
}

void ReadingScorer::addIdentified(const Detection& detection, std::size_t landmark, double volume)
{
  const double clutter = clutterOf(clutter_, reading_.model, landmark);
  const DetectionKind kind = detectionKind(detection, map_[landmark], frame_);
  PreparedDetection prepared = prepareDetection(detection, map_[landmark], clutter, frame_);
  double scale = 1;
  if (kind.sharp)
  {
    // Both parts of the mixture at most 1, so that products of some stay in single precision.
    scale = std::max(peakOf(detection, clutter), clutter / volume);
    constant_ += std::log(scale);
    prepared.peak = static_cast<float>(peakOf(detection, clutter) / scale);
  }
  prepared.floor = static_cast<float>(clutter / volume / scale);
  Group& group = groupOf(kind);
  group.together = std::min(group.together, factorsPerLogarithm(prepared.floor));
  group.detections.push_back(prepared);
}

ReadingScorer::Group& ReadingScorer::groupOf(const DetectionKind& kind)
{
  const auto same = [&](const Group& group)
  { return group.kind.bearing == kind.bearing && group.kind.range == kind.range && group.kind.sharp == kind.sharp; };
  const auto found = std::find_if(groups_.begin(), groups_.end(), same);
  return found != groups_.end() ? *found : groups_.emplace_back(Group{.kind = kind});
}

void ReadingScorer::addTo(const PoseBatch& robots, std::span<float> log_likelihood) const
{
  BlockTerms terms;
  if (!anonymous_.empty() || missed_) terms.culling.emplace(map_, frame_);
  for (std::size_t first = 0, count = 0; first < robots.size(); first += count)
  {
    count = std::min(kBlockTiles * kTile, robots.size() - first);
    if (terms.culling && isSpread(robots, first, count)) count = std::min(kTile, count);
    scoreBlock(robots, first, count, terms, log_likelihood);
  }
}

/// True for robots so far apart that they see different landmarks: a block of one tile then leaves out more.
bool ReadingScorer::isSpread(const PoseBatch& robots, std::size_t first, std::size_t count) const
{
  const auto extent = [&](std::span<const float> column)
  {
    const auto [low, high] = std::minmax_element(column.begin(), column.end());
    return double{*high} - double{*low};
  };
  const double range = reading_.model.max_range.value_or(std::numeric_limits<double>::infinity());
  return std::max(extent(robots.x.subspan(first, count)), extent(robots.y.subspan(first, count))) > range;
}

void ReadingScorer::scoreBlock(const PoseBatch& robots, std::size_t first, std::size_t count, BlockTerms& terms,
                               std::span<float> log_likelihood) const
{
  const std::size_t tiles = (count + kTile - 1) / kTile;
  for (std::size_t t = 0; t < tiles; ++t)
    fillTile(terms.tiles[t], robots, first + t * kTile, std::min(kTile, count - t * kTile), reading_);
  if (terms.culling)
  {
    terms.culling->update(boundsOf(std::span(terms.tiles).first(tiles)), VisibilityLimits(reading_.model));
    anonymous_.prepare(*terms.culling, terms.anonymous);
    if (missed_) missed_->prepare(*terms.culling, terms.missed);
  }
  for (std::size_t t = 0; t < tiles; ++t)
  {
    alignas(64) SensorTile::Column log_sum;
    std::fill_n(log_sum, kTile, static_cast<float>(constant_));
    scoreTile(terms.tiles[t], terms, log_sum);
    const std::size_t begin = first + t * kTile, in_tile = std::min(kTile, count - t * kTile);
    for (std::size_t i = 0; i < in_tile; ++i) log_likelihood[begin + i] += log_sum[i];
  }
}

void ReadingScorer::scoreTile(const SensorTile& tile, const BlockTerms& terms, SensorTile::Column& log_sum) const
{
  alignas(64) SensorTile::Column density;
  for (const Group& group : groups_)
  {
    WorkCounter::add(kTile * group.detections.size());
    if (group.kind.sharp)
    {
      addLogMixtures(tile, group.detections, group.kind, group.together, log_sum);
      continue;
    }
    for (const PreparedDetection& prepared : group.detections)
    {
      std::fill_n(density, kTile, 0.0F);
      // An identified detection was reported, so it was in view, whatever the declared limits say.
      addBroadDensities(tile, {&prepared, 1}, group.kind, frame_.sensor_covariance, VisibilityLimits(), density);
      addLogOfSum(density, prepared.floor, log_sum);
    }
  }
  anonymous_.addTo(tile, terms.anonymous, log_sum);
  if (missed_) missed_->addTo(tile, terms.missed, log_sum);
}
}  // namespace mrpt_ext
