#pragma once

#include <optional>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext::plain
{
/// The plain way to find a lost robot from bearings: triples of neighbouring readings against all local triples of
/// landmarks, every further reading tested with one fixed tolerance, given up after two early misses, and the first
/// pose that explains three quarters is the answer. Fast, but it knows nothing of a triple's own uncertainty and loses
/// the truth in every fifth trial. The place must have a range limit.
[[nodiscard]] std::optional<Pose2> searchBearings(const LandmarkIndex& map, const Scan& place);
}  // namespace mrpt_ext::plain
