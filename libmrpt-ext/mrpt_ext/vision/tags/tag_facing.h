#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/geometry/facing.h"
#include "mrpt_ext/vision/tags/tag_pose.h"

namespace mrpt_ext
{
/// Which way a tag faces, from the camera's forward axis, seen from above. `poses` are those of posesOfTag(), each
/// becomes an attitude: its probability, mean and standard deviation are those of the likelihood of the corners over
/// all directions nearer to it, with all else fitted to each direction. A tag seen from the front looks the same turned
/// a little either way: there the likelihood is no Gaussian about its maximum, and the inverse of the normal equations
/// is not its variance. Nothing for a tag that lies or hangs nearly flat.
[[nodiscard]] std::optional<Facing> facingOf(const std::vector<TagPose>& poses, const TagCorners& corners, double edge,
                                             const PinholeCamera& camera, const TagNoise& noise);
}  // namespace mrpt_ext
