#include "mrpt_ext/likelihood/visibility_kernels.h"

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/likelihood/tile_geometry.h"

namespace mrpt_ext
{
namespace
{
using namespace tile_geometry;
constexpr std::size_t kSize = SensorTile::kSize;

template <bool LimitsBearing>
[[gnu::always_inline]] inline float visibilityAt(const SensorTile& tile, std::size_t i, const ViewedLandmark& landmark,
                                                 const TileLimits& limits)
{
  const Offset to = offsetTo(landmark.x, landmark.y, tile.x[i], tile.y[i]);
  return visibilityOf<LimitsBearing>(to, landmark.rise2, tile.cosine[i], tile.sine[i], limits);
}

template <bool LimitsBearing>
[[gnu::always_inline]] inline void sumVisibility(const SensorTile& tile, std::span<const ViewedLandmark> landmarks,
                                                 const TileLimits& limits, float* visibility, float* clutter)
{
  for (const ViewedLandmark& landmark : landmarks) MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kSize; ++i)
  {
    const float c = visibilityAt<LimitsBearing>(tile, i, landmark, limits);
    visibility[i] += c;
    clutter[i] += c * landmark.clutter;
  }
}

template <bool LimitsBearing>
[[gnu::always_inline]] inline void countMoments(const SensorTile& tile, std::span<const ViewedLandmark> landmarks,
                                                const TileLimits& limits, float detection_probability, float* mean,
                                                float* variance)
{
  for (const ViewedLandmark& landmark : landmarks) MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kSize; ++i)
  {
    const float p = detection_probability * visibilityAt<LimitsBearing>(tile, i, landmark, limits);
    mean[i] += p;
    variance[i] += p * (1.0F - p);
  }
}

template <bool LimitsBearing, int Count>
[[gnu::always_inline]] inline void logReports(const SensorTile& tile, const ViewedLandmark* landmarks,
                                              const TileLimits& limits, float* log_sum)
{
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kSize; ++i)
  {
    float product = 1;
    for (int k = 0; k < Count; ++k)
      product *= landmarks[k].base + landmarks[k].gain * visibilityAt<LimitsBearing>(tile, i, landmarks[k], limits);
    log_sum[i] += vector_math::logOf(product);
  }
}

/// Four at a time: no probability is below 0.005, so that products are far from underflow.
template <bool LimitsBearing>
[[gnu::always_inline]] inline void allLogReports(const SensorTile& tile, std::span<const ViewedLandmark> landmarks,
                                                 const TileLimits& limits, float* log_sum)
{
  std::size_t j = 0;
  for (; j + 4 <= landmarks.size(); j += 4) logReports<LimitsBearing, 4>(tile, &landmarks[j], limits, log_sum);
  for (; j < landmarks.size(); ++j) logReports<LimitsBearing, 1>(tile, &landmarks[j], limits, log_sum);
}
}  // namespace

ViewedLandmark viewedLandmark(const Landmark& landmark, const ScoringFrame& frame, double clutter)
{
  const double rise = frame.horizontal_range ? 0.0 : landmark.position.z() - frame.sensor_height;
  return {.x = static_cast<float>(landmark.position.x() - frame.origin.x()),
          .y = static_cast<float>(landmark.position.y() - frame.origin.y()),
          .rise2 = static_cast<float>(square(rise)),
          .clutter = static_cast<float>(clutter)};
}

MRPT_EXT_VECTOR_CLONES
void addVisibility(const SensorTile& tile, std::span<const ViewedLandmark> landmarks, const VisibilityLimits& limits,
                   SensorTile::Column& visibility, SensorTile::Column& clutter)
{
  if (limits.limitsBearing())
    sumVisibility<true>(tile, landmarks, TileLimits(limits), visibility, clutter);
  else
    sumVisibility<false>(tile, landmarks, TileLimits(limits), visibility, clutter);
}

MRPT_EXT_VECTOR_CLONES
void addCountMoments(const SensorTile& tile, std::span<const ViewedLandmark> landmarks, const VisibilityLimits& limits,
                     float detection_probability, SensorTile::Column& mean, SensorTile::Column& variance)
{
  if (limits.limitsBearing())
    countMoments<true>(tile, landmarks, TileLimits(limits), detection_probability, mean, variance);
  else
    countMoments<false>(tile, landmarks, TileLimits(limits), detection_probability, mean, variance);
}

MRPT_EXT_VECTOR_CLONES
void addLogReports(const SensorTile& tile, std::span<const ViewedLandmark> landmarks, const VisibilityLimits& limits,
                   SensorTile::Column& log_sum)
{
  if (limits.limitsBearing())
    allLogReports<true>(tile, landmarks, TileLimits(limits), log_sum);
  else
    allLogReports<false>(tile, landmarks, TileLimits(limits), log_sum);
}
}  // namespace mrpt_ext
