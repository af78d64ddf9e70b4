#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/bearings/direction_table.h"
#include "mrpt_ext/correspondence/bearings/potentially_visible_sets.h"
#include "mrpt_ext/correspondence/bearings/triple_pose.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// A scan to count inliers in, with the pose of its sensor relative to the sensor whose poses are tested.
struct BoundingScan
{
  const DirectionTable* table = nullptr;
  const PotentiallyVisibleSets* visible_sets = nullptr;
  Pose2 T_tested_sensor;
  std::uint32_t used = 0;  ///< bearings that are inliers of the tested poses by construction
};

/// For each pose an upper bound on the number of its inliers: bearings with a landmark in the gate that the
/// covariance of the pose gives them. Never too low for a pose within `gate` standard deviations of the truth, up
/// to the curvature of bearings. Below `least` the bound need not be exact. `around`: landmark i in the world.
void boundInliers(const TriplePoses& poses, const Vector2d& around, std::span<const BoundingScan> scans, double gate,
                  int least, std::vector<std::uint16_t>& inliers);

/// Upper bound on the number of inliers of any sensor pose in a box. `box`: its covariance is diagonal, equal in x
/// and y; the tested sensor is that of `scan`.
[[nodiscard]] int boundOfBox(const GaussianPose& box, const BoundingScan& scan, double gate);

/// A landmark within the gates of more bearings than this is close: it matches one of them, any one.
constexpr int kMostOfOneLandmark = 4;

/// The potentially visible landmarks of a scan, seen from one tested pose; arrays of equal length.
struct GatedLandmarks
{
  std::vector<std::uint32_t> inliers;  ///< bearings within the gate, one bit each; 0: landmark out of range
  std::vector<float> x, y;             ///< [m] in the sensor's axes
  std::vector<float> ex, ey, w;        ///< row of the bearing's Jacobian: (ex, ey, -w)
  std::vector<float> variance;         ///< of the bearing, from the pose [rad^2]
  std::size_t count = 0;
};

/// Computes for each landmark around a pose which bearings it may match.
void landmarkGates(const GaussianPose& tested, const BoundingScan& scan, double gate, GatedLandmarks& seen);
}  // namespace mrpt_ext
