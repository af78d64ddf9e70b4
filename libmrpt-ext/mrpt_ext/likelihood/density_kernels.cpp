#include "mrpt_ext/likelihood/density_kernels.h"

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/likelihood/tile_geometry.h"

namespace mrpt_ext
{
namespace
{
using namespace tile_geometry;
constexpr std::size_t kSize = SensorTile::kSize;

/// Exponent to base 2 of the Gaussian of sharp prepared `at` for robot i.
template <bool Bearing, bool Range>
[[gnu::always_inline]] inline float sharpExponent(const SensorTile& tile, std::size_t i, const PreparedDetection& at)
{
  const Offset to = offsetTo(at.landmark_x, at.landmark_y, tile.x[i], tile.y[i]);
  float exponent = 0;
  if constexpr (Bearing)
    exponent = at.bearing_factor *
               sharpBearingError2(to, at.ray_x, at.ray_y, tile.bearing_frame_cosine[i], tile.bearing_frame_sine[i]);
  if constexpr (Range)
  {
    const float predicted = tile.range_scale[i] * std::sqrt(to.distance2 + at.rise2) + tile.range_shift[i];
    const float error = at.range - predicted;
    exponent += at.range_factor * error * error;
  }
  return exponent;
}

/// Applies a loop over the tile to the detections, at most `together` (8, 4 or 1) at a time.
template <class Loop, bool Bearing, bool Range>
[[gnu::always_inline]] inline void inGroups(const SensorTile& tile, std::span<const PreparedDetection> detections,
                                            int together, float* out)
{
  std::size_t d = 0;
  for (; together >= 8 && d + 8 <= detections.size(); d += 8)
    Loop::template over<8, Bearing, Range>(tile, &detections[d], out);
  for (; together >= 4 && d + 4 <= detections.size(); d += 4)
    Loop::template over<4, Bearing, Range>(tile, &detections[d], out);
  for (; together >= 4 && d + 2 <= detections.size(); d += 2)
    Loop::template over<2, Bearing, Range>(tile, &detections[d], out);
  for (; d < detections.size(); ++d) Loop::template over<1, Bearing, Range>(tile, &detections[d], out);
}

template <class Loop>
[[gnu::always_inline]] inline void ofKind(DetectionKind kind, const SensorTile& tile,
                                          std::span<const PreparedDetection> detections, int together, float* out)
{
  if (kind.bearing && kind.range)
    inGroups<Loop, true, true>(tile, detections, together, out);
  else if (kind.bearing)
    inGroups<Loop, true, false>(tile, detections, together, out);
  else
    inGroups<Loop, false, true>(tile, detections, together, out);
}

struct LogMixtures
{
  template <int Count, bool Bearing, bool Range>
  [[gnu::always_inline]] static void over(const SensorTile& tile, const PreparedDetection* at, float* log_sum)
  {
    MRPT_EXT_INDEPENDENT_ITERATIONS
    for (std::size_t i = 0; i < kSize; ++i)
    {
      float product = 1;
      for (int k = 0; k < Count; ++k)
        product *= at[k].peak * vector_math::exp2Of(sharpExponent<Bearing, Range>(tile, i, at[k])) + at[k].floor;
      log_sum[i] += vector_math::logOf(product);
    }
  }
};

struct Densities
{
  template <int Count, bool Bearing, bool Range>
  [[gnu::always_inline]] static void over(const SensorTile& tile, const PreparedDetection* at, float* sum)
  {
    MRPT_EXT_INDEPENDENT_ITERATIONS
    for (std::size_t i = 0; i < kSize; ++i)
    {
      float more = 0;
      for (int k = 0; k < Count; ++k)
        more += at[k].peak * vector_math::exp2Of(sharpExponent<Bearing, Range>(tile, i, at[k]));
      sum[i] += more;
    }
  }
};

struct SensorCovariance
{
  float xx, xy, yy;
};

template <bool Bearing, bool Range, bool LimitsBearing>
[[gnu::always_inline]] inline void broadDensity(const SensorTile& tile, const PreparedDetection& at,
                                                const SensorCovariance& sensor_covariance, const TileLimits& limits,
                                                float* sum)
{
  constexpr float kInvRootTwoPi = 0.398942280F, kHalfLog2E = -0.721347520F;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kSize; ++i)
  {
    const Offset to = offsetTo(at.landmark_x, at.landmark_y, tile.x[i], tile.y[i]);
    const float c = tile.cosine[i], s = tile.sine[i];
    const float x = c * to.dx + s * to.dy, y = c * to.dy - s * to.dx;
    const float slant2 = to.distance2 + at.rise2;
    float exponent = 0, density = at.inlier_probability;
    if constexpr (Bearing)
    {
      const float error =
          bearingError(to, at.ray_x, at.ray_y, tile.bearing_frame_cosine[i], tile.bearing_frame_sine[i]);
      const float across = to.dy * to.dy * at.map_xx + to.dx * to.dx * at.map_yy + y * y * sensor_covariance.xx -
                           2.0F * x * y * sensor_covariance.xy + x * x * sensor_covariance.yy;
      const float extra = (across > 0.0F ? across : 0.0F) / (to.distance2 * to.distance2);
      const float inverse = 1.0F / (at.var_bearing + extra);
      exponent = kHalfLog2E * error * error * inverse;
      density *= kInvRootTwoPi * std::sqrt(inverse);
    }
    if constexpr (Range)
    {
      const float error = at.range - (tile.range_scale[i] * std::sqrt(slant2) + tile.range_shift[i]);
      const float along = to.dx * to.dx * at.map_xx + to.dy * to.dy * at.map_yy + x * x * sensor_covariance.xx +
                          2.0F * x * y * sensor_covariance.xy + y * y * sensor_covariance.yy;
      const float inverse = 1.0F / (at.var_range + (along > 0.0F ? along : 0.0F) / slant2);
      exponent += kHalfLog2E * error * error * inverse;
      density *= kInvRootTwoPi * std::sqrt(inverse);
    }
    sum[i] += density * visibilityOf<LimitsBearing>(to, at.rise2, c, s, limits) * vector_math::exp2Of(exponent);
  }
}

template <bool LimitsBearing>
[[gnu::always_inline]] inline void broadDensities(const SensorTile& tile, std::span<const PreparedDetection> detections,
                                                  DetectionKind kind, const SensorCovariance& sensor_covariance,
                                                  const TileLimits& limits, float* sum)
{
  for (const PreparedDetection& at : detections)
    if (kind.bearing && kind.range)
      broadDensity<true, true, LimitsBearing>(tile, at, sensor_covariance, limits, sum);
    else if (kind.bearing)
      broadDensity<true, false, LimitsBearing>(tile, at, sensor_covariance, limits, sum);
    else
      broadDensity<false, true, LimitsBearing>(tile, at, sensor_covariance, limits, sum);
}

MRPT_EXT_VECTOR_CLONES
void broadDensitiesEverywhere(const SensorTile& tile, std::span<const PreparedDetection> detections, DetectionKind kind,
                              const SensorCovariance& sensor_covariance, const TileLimits& limits, float* sum)
{
  broadDensities<false>(tile, detections, kind, sensor_covariance, limits, sum);
}

MRPT_EXT_VECTOR_CLONES
void broadDensitiesInView(const SensorTile& tile, std::span<const PreparedDetection> detections, DetectionKind kind,
                          const SensorCovariance& sensor_covariance, const TileLimits& limits, float* sum)
{
  broadDensities<true>(tile, detections, kind, sensor_covariance, limits, sum);
}
}  // namespace

MRPT_EXT_VECTOR_CLONES
void addLogMixtures(const SensorTile& tile, std::span<const PreparedDetection> detections, DetectionKind kind,
                    int together, SensorTile::Column& log_sum)
{
  ofKind<LogMixtures>(kind, tile, detections, together, log_sum);
}

MRPT_EXT_VECTOR_CLONES
void addDensities(const SensorTile& tile, std::span<const PreparedDetection> detections, DetectionKind kind,
                  SensorTile::Column& sum)
{
  ofKind<Densities>(kind, tile, detections, 4, sum);
}

void addBroadDensities(const SensorTile& tile, std::span<const PreparedDetection> detections, DetectionKind kind,
                       const Matrix2d& sensor_covariance, const VisibilityLimits& limits, SensorTile::Column& sum)
{
  const SensorCovariance covariance{static_cast<float>(sensor_covariance(0, 0)),
                                    static_cast<float>(sensor_covariance(0, 1)),
                                    static_cast<float>(sensor_covariance(1, 1))};
  const auto add = limits.limitsBearing() ? broadDensitiesInView : broadDensitiesEverywhere;
  add(tile, detections, kind, covariance, TileLimits(limits), sum);
}

MRPT_EXT_VECTOR_CLONES
void addLogOfSum(const SensorTile::Column& density, float floor, SensorTile::Column& log_sum)
{
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kSize; ++i) log_sum[i] += vector_math::logOf(density[i] + floor);
}
}  // namespace mrpt_ext
