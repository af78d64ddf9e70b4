#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/local_map/past_scan.h"
#include "mrpt_ext/solvers/window_landmark.h"

namespace mrpt_ext
{
/// Sightings that seem to show one landmark, from one scan after the other.
struct LandmarkTrack
{
  struct Member
  {
    std::size_t scan = 0, detection = 0;
  };
  int category = kAnyCategory;
  std::vector<Member> members;  ///< by scan, at most one of each
  GaussianPoint point;          ///< robot frame of now [m], of a finished track
  bool located = false;         ///< its sightings hold a point: no longer a mere direction
};

/// The track's sightings as seen from scan `reference`: what odometry adds on the way before it, nothing after.
[[nodiscard]] std::vector<WindowObservation> sightingsOf(const LandmarkTrack& track, std::span<const PastScan> scans,
                                                         const Matrix3d& reference_covariance);

/// Where a later scan should see the track's landmark.
struct TrackPrediction
{
  GaussianPoint point;          ///< robot frame of now; covariance relative to that scan
  double bearing_variance = 0;  ///< further variance of the bearing [rad^2]
  bool depth_known = false;     ///< false: the range means nothing
};

/// A located track predicts a point. A direction alone predicts the bearing of a landmark at an inverse depth of
/// 1/4 +- 1/4 of 1 / `nearest` (inverse depth: Civera, Davison, Montiel 2008; its error is Gaussian where that of a
/// depth is not).
[[nodiscard]] TrackPrediction predictTrack(const LandmarkTrack& track, std::span<const PastScan> scans, std::size_t at,
                                           double nearest);

/// How well a detection agrees with a prediction.
struct TrackFit
{
  double chi2 = 0;
  int values = 0;  ///< bearing, or bearing and range: degrees of freedom
};
[[nodiscard]] TrackFit compare(const TrackPrediction& expected, const PastScan& at,
                               const AnonymousDetection& detection);
}  // namespace mrpt_ext
