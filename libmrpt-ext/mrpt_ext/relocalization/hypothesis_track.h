#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// A piece of a way and what was seen at its end.
struct TrajectoryStep
{
  Pose2 increment;                    ///< by odometry since the step before
  Matrix3d noise = Matrix3d::Zero();  ///< covariance added to the increment: (x, y, phi), axes of the robot before
  std::vector<Scan> seen;             ///< T_robot_sensor: in the robot frame at the end of the step
};

/// A supposed pose that is carried along a way and confronted with all that is seen: one hypothesis of multi-hypothesis
/// localization (Jensfelt, Kristensen 2001; Arras et al. 2003). Detections without names are given to landmarks by the
/// pose itself; a Kalman filter takes in what fits.
struct HypothesisTrack
{
  GaussianPose pose;
  double log_evidence = 0;  ///< of all it was confronted with, given its first pose
};

/// Over the step, and back again. Noise grows both ways.
void predict(HypothesisTrack& track, const TrajectoryStep& step);
void retrodict(HypothesisTrack& track, const TrajectoryStep& step);

/// Confronts the track with a look. Per detection the evidence grows by the log of
///   c / V + (1 - c) / n N(z; h, S),
/// n landmarks in view, S with the pose's uncertainty, c / V the density of false ones; the landmark is the closest
/// within `gate` standard deviations, one for each detection of a place, and the pose takes it in where it is likelier
/// than a false one. Returns the landmark taken in for every detection, -1 for none.
std::vector<int> update(HypothesisTrack& track, const LandmarkIndex& map, std::span<const Scan> seen, double gate);

/// The same with the landmarks given, for a track whose pose is hardly known yet.
void updateAssociated(HypothesisTrack& track, const LandmarkIndex& map, std::span<const Scan> seen,
                      std::span<const int> landmarks);

/// The evidence that the right track may expect of a look: every detection fits as well as its deviations say, as many
/// are false as the sensor declares.
[[nodiscard]] double expectedEvidence(const LandmarkIndex& map, std::span<const Scan> seen);
}  // namespace mrpt_ext
