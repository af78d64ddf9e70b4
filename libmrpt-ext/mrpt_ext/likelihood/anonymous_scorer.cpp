#include "mrpt_ext/likelihood/anonymous_scorer.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"
#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/likelihood/density_kernels.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kCostOfBroad = 3;  // densities that are not sharp take so much longer

/// log_sum += ln of the mixture: each landmark's part weighted by its visibility, together 1. Where none can be in
/// view, the detection is clutter.
MRPT_EXT_VECTOR_CLONES
void addLogOfShares(const SensorTile::Column& density, const SensorTile::Column& visibility,
                    const SensorTile::Column& clutter, float clutter_density, float clutter_out_of_view,
                    SensorTile::Column& log_sum)
{
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < SensorTile::kSize; ++i)
  {
    const bool seen = visibility[i] > 0.0F;
    const float inverse = 1.0F / (seen ? visibility[i] : 1.0F);
    const float mixture = (density[i] + clutter[i] * clutter_density) * inverse;
    log_sum[i] += vector_math::logOf(seen ? mixture : clutter_out_of_view * clutter_density);
  }
}

}  // namespace

AnonymousScorer::AnonymousScorer(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& clutter,
                                 const ScoringFrame& frame, double default_max_range)
    : reading_(reading), map_(map), clutter_(clutter), frame_(frame), limits_(reading.model)
{
  for (const Detection& detection : reading.detections)
  {
    if (detection.id != kNoId) continue;
    const std::size_t set = setOf(detection);
    if (sets_[set].landmarks.empty()) continue;  // nothing in the map can explain it: a constant
    const double volume = measurementVolume(detection, reading.model, default_max_range);
    const double least_floor = sets_[set].least_clutter / volume;
    const double cut = std::sqrt(2 * std::log(std::max(1.0, peakOf(detection, 0) / (kNeglected * least_floor))));
    detections_.push_back({&detection, set, static_cast<float>(1 / volume), cut});
  }
}

std::size_t AnonymousScorer::setOf(const Detection& detection)
{
  for (std::size_t k = 0; k < sets_.size(); ++k)
    if (sets_[k].category == detection.category) return k;
  CandidateSet set{.category = detection.category};
  for (std::size_t j = 0; j < map_.size(); ++j)
  {
    if (!mayShow(detection, map_[j])) continue;
    const double clutter = clutterOf(clutter_, reading_.model, j);
    set.landmarks.push_back(static_cast<std::uint32_t>(j));
    set.mean_clutter += clutter;
    set.least_clutter = std::min(set.least_clutter, clutter);
  }
  set.mean_clutter /= std::max(1.0, static_cast<double>(set.landmarks.size()));
  sets_.push_back(std::move(set));
  return sets_.size() - 1;
}

void AnonymousScorer::prepare(const LandmarkCulling& culling, Terms& terms) const
{
  terms.sets.resize(sets_.size());
  for (std::size_t k = 0; k < sets_.size(); ++k)
  {
    terms.sets[k].rim.clear();
    double visibility = 0, clutter = 0;
    for (const std::uint32_t j : sets_[k].landmarks)
    {
      const InView in_view = culling.inView()[j];
      if (in_view == InView::no) continue;
      const double own = clutterOf(clutter_, reading_.model, j);
      if (in_view == InView::some) terms.sets[k].rim.push_back(viewedLandmark(map_[j], frame_, own));
      if (in_view != InView::all) continue;
      visibility += 1;
      clutter += own;
    }
    terms.sets[k].certain_visibility = static_cast<float>(visibility);
    terms.sets[k].certain_clutter = static_cast<float>(clutter);
  }
  terms.sums.resize(detections_.size());
  for (std::size_t d = 0; d < detections_.size(); ++d)
  {
    const AnonymousTerm& anonymous = detections_[d];
    auto& [sharp, broad] = terms.sums[d];
    sharp.clear();
    broad.clear();
    terms.near.clear();
    culling.findNear(*anonymous.detection, anonymous.cut, sets_[anonymous.set].landmarks, terms.near);
    for (const std::uint32_t j : terms.near)
    {
      const PreparedDetection prepared =
          prepareDetection(*anonymous.detection, map_[j], clutterOf(clutter_, reading_.model, j), frame_);
      const bool simple =
          culling.inView()[j] == InView::all && detectionKind(*anonymous.detection, map_[j], frame_).sharp;
      (simple ? sharp : broad).push_back(prepared);
    }
  }
}

void AnonymousScorer::addTo(const SensorTile& tile, const Terms& terms, SensorTile::Column& log_sum) const
{
  alignas(64) SensorTile::Column visibility, clutter, density;
  std::size_t summed_set = sets_.size();
  for (std::size_t d = 0; d < detections_.size(); ++d)
  {
    const AnonymousTerm& anonymous = detections_[d];
    if (anonymous.set != summed_set)
    {
      summed_set = anonymous.set;
      std::fill_n(visibility, SensorTile::kSize, terms.sets[summed_set].certain_visibility);
      std::fill_n(clutter, SensorTile::kSize, terms.sets[summed_set].certain_clutter);
      addVisibility(tile, terms.sets[summed_set].rim, limits_, visibility, clutter);
    }
    const DetectionKind kind{anonymous.detection->bearing.has_value(), anonymous.detection->range.has_value()};
    std::fill_n(density, SensorTile::kSize, 0.0F);
    WorkCounter::add(SensorTile::kSize * (terms.sums[d].sharp.size() + kCostOfBroad * terms.sums[d].broad.size()));
    addDensities(tile, terms.sums[d].sharp, kind, density);
    addBroadDensities(tile, terms.sums[d].broad, kind, frame_.sensor_covariance, limits_, density);
    addLogOfShares(density, visibility, clutter, anonymous.clutter_density,
                   static_cast<float>(sets_[summed_set].mean_clutter), log_sum);
  }
}
}  // namespace mrpt_ext
