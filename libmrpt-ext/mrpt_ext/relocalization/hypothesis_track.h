#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// One step of a trajectory: the odometry since the previous step, and the anonymous scans at the pose it leads to.
struct TrajectoryStep
{
  Pose2 increment;                    ///< odometry, in the robot frame of the previous step
  Matrix3d noise = Matrix3d::Zero();  ///< covariance of the increment, order (x, y, phi), in the same axes
  std::vector<Scan> scans;            ///< T_robot_sensor: in the robot frame of this step
};

/// One hypothesis of multi-hypothesis localization (Jensfelt and Kristensen, "Active global localization for a mobile
/// robot using multiple hypothesis tracking", 2001): a Gaussian pose with a Kalman filter of its own, which associates
/// anonymous detections by itself, and the evidence that ranks it among the others.
struct HypothesisTrack
{
  GaussianPose pose;
  double log_evidence = 0;  ///< log p(all updates | initial pose)
};

/// Propagates the pose over a step, forward from the previous step or backward from its own. Noise is added either way.
void predict(HypothesisTrack& track, const TrajectoryStep& step);
void retrodict(HypothesisTrack& track, const TrajectoryStep& step);

/// Kalman update with the detections of a step, each associated with the nearest landmark within `gate` standard
/// deviations, one landmark per detection of a scan. The evidence of a detection is
///   c / V + (1 - c) / n N(z; h, S)
/// with n landmarks in view, the innovation covariance S and the clutter density c / V; a detection more likely to be
/// clutter does not change the pose. Returns the index of the landmark used for every detection, -1 for none.
std::vector<int> update(HypothesisTrack& track, const LandmarkIndex& map, std::span<const Scan> scans, double gate);

/// The same with given associations, as returned by update(): for a track whose pose is still too uncertain for them.
void updateAssociated(HypothesisTrack& track, const LandmarkIndex& map, std::span<const Scan> scans,
                      std::span<const int> landmarks);

/// Expected log-evidence of scans for the true pose: detections distributed as their standard deviations state, clutter
/// as the sensor declares.
[[nodiscard]] double expectedEvidence(const LandmarkIndex& map, std::span<const Scan> scans);
}  // namespace mrpt_ext
