#pragma once

#include <cstddef>
#include <optional>

#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// Detections of a frame that a localizer works with at most. A sensor reports tens; where it reports thousands,
/// something else than landmarks is detected, and what hundreds cannot tell, all of them cannot either.
inline constexpr std::size_t kMostDetections = 400;

/// Of a Kalman filter, which compares each with every landmark, for each of its hypotheses.
inline constexpr std::size_t kMostKalmanDetections = 100;
/// Of several frames joined.
inline constexpr std::size_t kMostJoined = 2 * kMostDetections;

/// The number of detections and running fixes of a frame.
[[nodiscard]] std::size_t detectionCount(const Frame& frame);

/// The frame with `most` of its detections, each reading with its share of them in all directions
/// (even_choice.h); what was left out is not missed. Nothing for a frame without too many.
[[nodiscard]] std::optional<Frame> boundedFrame(const Frame& frame, std::size_t most = kMostDetections);

/// The frame with so many of its detections, at least one, that work which grows with their number takes
/// `most_operations` instead of the `operations` of the whole frame. Nothing for a frame that takes no more.
[[nodiscard]] std::optional<Frame> affordableFrame(const Frame& frame, double operations, double most_operations);
}  // namespace mrpt_ext
