#pragma once

namespace mrpt_ext
{
/// The inlier ratio of recent detections, relative to the expected one, below which a mode is not `ok`.
inline constexpr double kMinInlierRatio = 0.8;
}  // namespace mrpt_ext
