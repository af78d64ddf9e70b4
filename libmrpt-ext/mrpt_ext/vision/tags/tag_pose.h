#pragma once

#include <vector>

#include "mrpt_ext/vision/tags/tag_values.h"

namespace mrpt_ext
{
/// The poses of a square of this edge [m], most likely first: one, or two where a perspective too weak for the noise
/// leaves it open which side is nearer (Collins, Bartoli, "Infinitesimal plane-based pose estimation", 2014; here both
/// are found by descent, the second from the first, mirrored at the line of sight). None where the corners enclose no
/// area, are not convex or lie where the lens has no inverse.
/// Of a small tag seen from the front nothing but noise tells the attitude, and every tilt makes it seem nearer: its
/// range is too short by up to a standard deviation. Upright edges show the range without that.
[[nodiscard]] std::vector<TagPose> posesOfTag(const TagCorners& corners, double edge, const PinholeCamera& camera,
                                              const TagNoise& noise);
}  // namespace mrpt_ext
