#pragma once

#include <cstddef>

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// One sensor on kSize robots: everything about a robot that the likelihood of a detection needs, as columns in single
/// precision that fit the first-level cache. All loops run over whole tiles; the last one is padded with its last
/// robot.
struct alignas(64) SensorTile
{
  static constexpr std::size_t kSize = 128;
  using Column = float[kSize];

  Column x, y;          ///< [m] sensor position from the origin of the batch
  Column cosine, sine;  ///< of the sensor's heading
  Column bearing_frame_cosine,
      bearing_frame_sine;               ///< of the heading that bearings refer to (bearing bias applied)
  Column range_scale{}, range_shift{};  ///< measured range = scale * true range + shift
};

/// Fills the tile from the `count` (1 to kSize) robots of the batch from `first` on. The range columns are left as they
/// are when the reading has no range.
void fillTile(SensorTile& tile, const PoseBatch& robots, std::size_t first, std::size_t count, const Reading& reading);
}  // namespace mrpt_ext
