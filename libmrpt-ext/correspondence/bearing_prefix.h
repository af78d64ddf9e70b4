#pragma once

#include <Eigen/Core>
#include <vector>

#include "mrpt_ext/correspondence/interpretation_tree.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// A landmark matched to a bearing [rad].
struct MatchedBearing
{
  Vector2d landmark{0, 0};
  double bearing = 0;
};

/// Least-squares pose of the bearings matched so far, and what it can say about further ones.
/// If every bearing is within `error` of its value at the (unknown) final pose, that pose lies within `shift` of this
/// one, and a landmark's bearing there within gateAt(...) of its prediction here, to first order, stretched for what
/// distances change over the shift.
struct BearingPrefix
{
  Pose2 pose;
  Eigen::Matrix3Xd sensitivity;  ///< d pose / d bearing, one column per matched bearing
  double sse = 0;                ///< sum of squared residuals [rad^2]
  double shift = 0;              ///< largest distance to the final pose [m]
  double nearest = 0;            ///< distance to the nearest matched landmark [m]
  bool reliable = false;         ///< false: too close to singular, or to a landmark, for first order to hold
};

/// Least squares (guarded) from `start` over `matched` (three or more), then the figures. A worst-case shift of more
/// than 0.6 of the distance to the nearest matched landmark makes the prefix unreliable.
void updatePrefix(BearingPrefix& prefix, const std::vector<MatchedBearing>& matched, const Pose2& start, double error);

/// Half-width of the gate [rad] for the bearing of a landmark at `to_landmark` from the prefix pose (world axes); pi
/// when the prefix says nothing about it.
[[nodiscard]] double gateAt(const BearingPrefix& prefix, const Vector2d& to_landmark, double error,
                            InterpretationGate gate);
}  // namespace mrpt_ext
