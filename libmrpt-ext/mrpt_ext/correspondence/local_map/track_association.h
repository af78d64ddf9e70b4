#pragma once

#include <algorithm>

#include "mrpt_ext/correspondence/local_map/landmark_track.h"
#include "mrpt_ext/geometry/work_budget.h"

namespace mrpt_ext
{
/// Gate of a detection against the prediction of its track [standard deviations].
inline constexpr double kTrackGate = 3.3;

/// Number of bearings that a track without ranges needs, over so many scans: any two bearings meet somewhere.
[[nodiscard]] inline std::size_t leastBearings(std::size_t scans)
{
  constexpr std::size_t kLeast = 4, kOneOfScans = 2;
  return std::max(kLeast, scans / kOneOfScans);
}

/// Associates anonymous detections of several scans (oldest first) to tracks, each of one supposed landmark. Every
/// detection with a range, and every two bearings of nearby scans that meet in a point, start a track, which then takes
/// from every later scan the closest detection within the gate of its prediction. Most of these tracks are wrong, but
/// the right ones have more detections: the track with the most evidence is kept, its detections are removed from all
/// others, and so on until none has enough left. Where `budget` ends it, further tracks are missing.
[[nodiscard]] std::vector<LandmarkTrack> associateTracks(std::span<const PastScan> oldest_first, WorkBudget& budget);
}  // namespace mrpt_ext
