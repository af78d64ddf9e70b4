#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/local_map/past_scan.h"
#include "mrpt_ext/solvers/window_landmark.h"

namespace mrpt_ext
{
/// Detections of one supposed landmark in successive scans.
struct LandmarkTrack
{
  struct Member
  {
    std::size_t scan = 0, detection = 0;
  };
  int category = kAnyCategory;
  std::vector<Member> members;  ///< in order of scans, at most one of each
  GaussianPoint point;          ///< present robot frame [m], of a finished track
  bool located = false;         ///< its detections determine a point, not only a direction
};

/// The detections of the track, with the odometry covariance relative to a reference scan's.
[[nodiscard]] std::vector<WindowObservation> observationsOf(const LandmarkTrack& track, std::span<const PastScan> scans,
                                                            const Matrix3d& reference_covariance);

/// Predicted measurement of the track's landmark in a later scan.
struct TrackPrediction
{
  GaussianPoint point;          ///< present robot frame; covariance relative to that scan
  double bearing_variance = 0;  ///< further variance of the bearing [rad^2]
  bool depth_known = false;     ///< false: the range is not predicted
};

/// A located track predicts a point. A direction alone predicts the bearing of a landmark at an inverse depth of
/// (1/4 +- 1/4) / 1 m (inverse depth: Civera, Davison, Montiel 2008; its error is Gaussian where that of a
/// depth is not).
[[nodiscard]] TrackPrediction predictTrack(const LandmarkTrack& track, std::span<const PastScan> scans, std::size_t at);

/// Residual of a detection against a prediction.
struct TrackFit
{
  double chi2 = 0;
  int values = 0;  ///< bearing, or bearing and range: degrees of freedom
};
[[nodiscard]] TrackFit compare(const TrackPrediction& expected, const PastScan& at,
                               const AnonymousDetection& detection);
}  // namespace mrpt_ext
