#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/local_map/track_association.h"

namespace mrpt_ext
{
struct LocalMapOptions
{
  TrackOptions tracks;
  double max_std = 0.3;  ///< [m] a point less certain than this in any direction is left as bearings
};

/// A landmark seen from one or more scans, as a point without a name.
struct LocalLandmark
{
  GaussianPoint in_robot;  ///< robot frame of now [m]
  int category = kAnyCategory;
  std::vector<LandmarkTrack::Member> members;  ///< the detections it stands for
};

/// What was seen along a short way, brought together without names.
struct LocalLandmarkMap
{
  std::vector<LocalLandmark> points;
  SensorModel seen_by;         ///< of the points: one sensor in the robot's centre that reaches as far as the way
  std::vector<PastScan> rest;  ///< detections that gave no point, at their scans; scans without any left out
};

/// Joins unidentified detections of several moments into one constellation, scans oldest first: finds the tracks
/// (track_association.h), then adjusts their points and the way together (local_bundle_adjustment.h), which corrects
/// odometry to where the sensor's own precision tells that a sighting does not belong; those, and points that stay
/// unsharp, are left out. So bearings along a short way gain distances, the invariant that a single shot does not have.
/// The rest is given at the corrected scans. One scan alone has nothing to join and stays as it is.
[[nodiscard]] LocalLandmarkMap buildLocalMap(std::span<const PastScan> oldest_first,
                                             const LocalMapOptions& options = {});

/// The constellation as a search takes it: the points as detections with bearing and range of one sensor in the robot's
/// centre, then the rest from its own scans, its deviations grown by odometry. Every landmark appears at most once
/// among the points. What was not seen counts for nothing any more.
/// A point's covariance is given as deviations along and across the line of sight, which is where it is long.
[[nodiscard]] std::vector<Scan> asScans(const LocalLandmarkMap& joined);
}  // namespace mrpt_ext
