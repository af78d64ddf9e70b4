#include "mrpt_ext/likelihood/sensor_tile.h"

#include <algorithm>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kSize = SensorTile::kSize;

struct alignas(64) RobotTile
{
  SensorTile::Column x, y, phi;
};

void copyPadded(std::span<const float> from, SensorTile::Column& to)
{
  std::copy(from.begin(), from.end(), to);
  std::fill(to + from.size(), to + kSize, from.back());
}

/// Sensor pose on the robot, as the loop below needs it.
struct SensorOffset
{
  float x, y, yaw_cosine, yaw_sine;

  explicit SensorOffset(const Pose2& T_robot_sensor)
      : x(static_cast<float>(T_robot_sensor.x)),
        y(static_cast<float>(T_robot_sensor.y)),
        yaw_cosine(static_cast<float>(std::cos(T_robot_sensor.phi))),
        yaw_sine(static_cast<float>(std::sin(T_robot_sensor.phi)))
  {
  }
};

/// Sensor poses from robot poses.
MRPT_EXT_VECTOR_CLONES
void placeSensors(const float* x, const float* y, const float* phi, const SensorOffset& offset, SensorTile& tile)
{
  const SensorOffset at = offset;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kSize; ++i)
  {
    const auto [s, c] = vector_math::sineCosineOf(phi[i]);
    tile.x[i] = x[i] + c * at.x - s * at.y;
    tile.y[i] = y[i] + s * at.x + c * at.y;
    tile.cosine[i] = tile.bearing_frame_cosine[i] = c * at.yaw_cosine - s * at.yaw_sine;
    tile.sine[i] = tile.bearing_frame_sine[i] = s * at.yaw_cosine + c * at.yaw_sine;
  }
}

MRPT_EXT_VECTOR_CLONES
void turnBearingFrame(const SensorTile::Column& bearing_offset, SensorTile& tile)
{
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kSize; ++i)
  {
    const auto [s, c] = vector_math::sineCosineOf(bearing_offset[i]);
    tile.bearing_frame_cosine[i] = tile.cosine[i] * c + tile.sine[i] * s;
    tile.bearing_frame_sine[i] = tile.sine[i] * c - tile.cosine[i] * s;
  }
}

void addColumn(std::span<const float> column, SensorTile::Column& sum)
{
  for (std::size_t i = 0; i < kSize; ++i) sum[i] += column[std::min(i, column.size() - 1)];
}

/// Range and bearing errors of the sensor, summed over the bias states that act on it.
void applyBiases(SensorTile& tile, const PoseBatch& robots, std::size_t first, std::size_t count,
                 const Reading& reading, bool ranges)
{
  alignas(64) SensorTile::Column bearing_offset{};
  bool turned = false;
  for (std::size_t k = 0; k < robots.bias_states.size(); ++k)
  {
    const BiasState& state = robots.bias_states[k];
    if (!actsOn(state, reading.sensor)) continue;
    const auto column = robots.bias[k].subspan(first, count);
    if (ranges && state.kind == BiasKind::range_scale) addColumn(column, tile.range_scale);
    if (ranges && state.kind == BiasKind::range_offset) addColumn(column, tile.range_shift);
    if (state.kind == BiasKind::bearing_offset) addColumn(column, bearing_offset);
    turned = turned || state.kind == BiasKind::bearing_offset;
  }
  if (turned) turnBearingFrame(bearing_offset, tile);
}

bool hasRange(const Reading& reading)
{
  return std::any_of(reading.detections.begin(), reading.detections.end(),
                     [](const Detection& detection) { return detection.range.has_value(); });
}
}  // namespace

void fillTile(SensorTile& tile, const PoseBatch& robots, std::size_t first, std::size_t count, const Reading& reading)
{
  const SensorOffset offset(reading.T_robot_sensor);
  if (count == kSize)
    placeSensors(&robots.x[first], &robots.y[first], &robots.phi[first], offset, tile);
  else
  {
    RobotTile padded;
    copyPadded(robots.x.subspan(first, count), padded.x);
    copyPadded(robots.y.subspan(first, count), padded.y);
    copyPadded(robots.phi.subspan(first, count), padded.phi);
    placeSensors(padded.x, padded.y, padded.phi, offset, tile);
  }
  const bool ranges = hasRange(reading);
  if (ranges)
  {
    std::fill_n(tile.range_scale, kSize, 1.0F);
    std::fill_n(tile.range_shift, kSize, 0.0F);
  }
  if (!robots.bias_states.empty()) applyBiases(tile, robots, first, count, reading, ranges);
}
}  // namespace mrpt_ext
