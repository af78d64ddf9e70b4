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
/// A scan to compare with: where its sensor is relative to the sensor whose poses are tested.
struct BoundingScan
{
  const DirectionTable* table = nullptr;
  const PotentiallyVisibleSets* visible_sets = nullptr;
  Pose2 T_tested_sensor;
  std::uint32_t used = 0;  ///< bearings that the tested poses explain by construction
};

/// For each pose an upper bound on the number of bearings that it explains: bearings with a landmark in the gate that
/// the pose's covariance gives it. Never too low for a pose within `gate` standard deviations of the truth, up to the
/// curvature of bearings. A bound below `least` may come out lower than it is. `around`: landmark i in the world.
void boundInliers(const TriplePoses& poses, const Vector2d& around, std::span<const BoundingScan> scans, double gate,
                  int least, std::vector<std::uint16_t>& inliers);

/// An upper bound on the number of bearings that a box of sensor poses explains, counted as refineOnInliers does but
/// without the details. `box`: its covariance is diagonal, alike in x and y, and the tested sensor is the scan's own.
[[nodiscard]] int boundOfBox(const GaussianPose& box, const BoundingScan& scan, double gate);

/// A landmark within the gates of more bearings than this is close, and explains one of them, no matter which.
constexpr int kMostOfOneLandmark = 4;

/// The landmarks that a scan could see, as seen from one tested pose; arrays of equal length.
struct GatedLandmarks
{
  std::vector<std::uint32_t> explains;  ///< bearings within the gate, one bit each; none for a landmark out of range
  std::vector<float> x, y;              ///< [m] in the sensor's axes
  std::vector<float> ex, ey, w;         ///< row of the bearing's Jacobian: (ex, ey, -w)
  std::vector<float> variance;          ///< of the bearing, from the pose [rad^2]
  std::size_t count = 0;
};

/// Looks up what the landmarks around a pose explain.
void landmarkGates(const GaussianPose& tested, const BoundingScan& scan, double gate, GatedLandmarks& seen);
}  // namespace mrpt_ext
