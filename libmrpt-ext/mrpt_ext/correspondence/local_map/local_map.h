#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/local_map/track_association.h"

namespace mrpt_ext
{
/// A landmark detected in one or more scans, as an anonymous point.
struct LocalLandmark
{
  GaussianPoint in_robot;  ///< present robot frame [m]
  int category = kAnyCategory;
  std::vector<LandmarkTrack::Member> members;  ///< its detections
};

/// Map of the landmarks detected in a window of scans.
struct LocalLandmarkMap
{
  std::vector<LocalLandmark> points;
  SensorModel sensor;  ///< of the points: one sensor at the robot's centre whose range covers the trajectory too
  std::vector<PastScan> rest;  ///< detections outside every point, at the corrected poses; empty scans left out
};

/// Builds a local map from the anonymous detections of several scans, oldest first: associates tracks
/// (track_association.h), then adjusts their points and the trajectory together (local_bundle_adjustment.h). That
/// corrects the odometry so far that the precision of the sensor shows which detections do not belong to their track;
/// those, and points with a large covariance, are left out. Bearings along a short trajectory thus gain distances, the
/// invariant that a single scan does not have. A single scan is returned as it is; so are several, without points,
/// where `budget` ends before they are consistent.
[[nodiscard]] LocalLandmarkMap buildLocalMap(std::span<const PastScan> oldest_first, WorkBudget& budget);

/// The same without a limit.
[[nodiscard]] inline LocalLandmarkMap buildLocalMap(std::span<const PastScan> oldest_first)
{
  WorkBudget unlimited;
  return buildLocalMap(oldest_first, unlimited);
}

/// The local map as scans for a search: the points as detections with bearing and range of one sensor at the robot's
/// centre, then the rest, with standard deviations increased by odometry. Each landmark appears at most once among the
/// points. Missed detections do not count. The covariance of a point is given as standard deviations along and across
/// the line of sight, which are its principal axes in good approximation.
[[nodiscard]] std::vector<Scan> asScans(const LocalLandmarkMap& local_map);
}  // namespace mrpt_ext
