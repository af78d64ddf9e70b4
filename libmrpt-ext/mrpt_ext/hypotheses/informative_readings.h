#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// Detections of a window that a search is given: more of the same landmarks hardly improve the points that they are
/// merged to, while the work of merging grows with the square of their number.
inline constexpr std::size_t kMostJoinedDetections = 400;
inline constexpr std::size_t kMostJoinedReadings = 24;  ///< of one sensor; their poses are unknowns too
inline constexpr std::size_t kLeastJoinedReadings = 6;  ///< of one sensor: bearings need several to become points

/// Of the readings of a window, oldest first, those that a search has use for: of each sensor every n-th, the newest
/// among them, so that the window keeps its length and with it the base line of its bearings.
[[nodiscard]] std::vector<Reading> informativeReadings(std::span<const Reading> oldest_first);
}  // namespace mrpt_ext
