#pragma once

#include <algorithm>

#include "mrpt_ext/correspondence/local_map/landmark_track.h"

namespace mrpt_ext
{
struct TrackOptions
{
  double gate = 3.3;             ///< how far a sighting may be off what its track predicts [standard deviations]
  double nearest = 1;            ///< [m] landmarks closer than this to the way are rare
  std::size_t min_bearings = 4;  ///< sightings that make a track of bearings: any two meet somewhere,
  double min_share = 0.5;        ///< and at least from this share of the scans
  std::size_t max_gap = 4;       ///< scans between the first two sightings
};

/// Sightings that a track of bearings needs.
[[nodiscard]] inline std::size_t leastBearings(const TrackOptions& options, std::size_t scans)
{
  return std::max(options.min_bearings, static_cast<std::size_t>(options.min_share * static_cast<double>(scans)));
}

/// Strings unidentified detections of several scans (oldest first) into tracks that each seem to show one landmark.
/// Every detection with a range, and every two bearings of scans near each other that meet in a point, start a track,
/// which then takes from every later scan the closest detection within the gate of what it predicts. Most of these
/// tracks are wrong, but the right ones explain more: the track with the most evidence is kept, its detections are
/// taken from all others, and so on until none has enough left.
[[nodiscard]] std::vector<LandmarkTrack> associateTracks(std::span<const PastScan> oldest_first,
                                                         const TrackOptions& options = {});
}  // namespace mrpt_ext
