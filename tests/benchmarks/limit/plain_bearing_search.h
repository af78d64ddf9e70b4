#pragma once

#include <optional>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext::plain
{
/// The simple search for a pose from bearings, as a reference: triples of neighbouring bearings against all local
/// triples of landmarks, every further bearing tested with one fixed tolerance, given up after two early misses; the
/// first pose with three quarters of the bearings as inliers is the answer. Fast, but it ignores the covariance of the
/// triple's pose and misses the true pose in every fifth trial. The scan must have a range limit.
[[nodiscard]] std::optional<Pose2> searchBearings(const LandmarkIndex& map, const Scan& scan);
}  // namespace mrpt_ext::plain
