#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Poses in four bytes each: x and y in 12 bits over the box around them, heading in 8 bits over a turn from 0 on.
/// Byte 0: upper bits of x; 1: lower bits of x, upper of y; 2: lower bits of y; 3: heading.
struct PackedPoses
{
  Vector2d low{0, 0}, extent{0, 0};  ///< [m] box
  std::string bytes;
};
[[nodiscard]] PackedPoses packPoses(const std::vector<Pose2>& poses);

/// Base64 (RFC 4648) of bytes.
[[nodiscard]] std::string base64(const std::string& bytes);
}  // namespace mrpt_ext
