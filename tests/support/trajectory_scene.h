#pragma once

#include <vector>

#include "mrpt_ext/solvers/window_landmark.h"
#include "mrpt_ext/solvers/window_pose.h"
#include "random_scene.h"

namespace mrpt_ext
{
/// A trajectory of equal steps: the truth, the odometry, and its covariance.
struct DrivenTrajectory
{
  std::vector<Pose2> true_poses;      ///< robot poses in the world, oldest first
  std::vector<Pose2> poses;           ///< by odometry, in the last robot frame
  std::vector<Matrix3d> covariances;  ///< of the odometry since each pose, in the last robot frame

  [[nodiscard]] const Pose2& now() const { return true_poses.back(); }
};

/// `steps` moves of `step` that end at `end`; every move has independent noise `std` (x, y, phi) in odometry.
inline DrivenTrajectory driveSteps(const Pose2& end, const Pose2& step, int steps, const Vector3d& std,
                                   RandomStream& random)
{
  DrivenTrajectory trajectory;
  trajectory.true_poses = {end};
  trajectory.poses = {Pose2{}};
  trajectory.covariances = {Matrix3d::Zero()};
  for (int k = 0; k < steps; ++k)
  {
    const Pose2 measured{step.x + std.x() * random.gaussian(), step.y + std.y() * random.gaussian(),
                         step.phi + std.z() * random.gaussian()};
    trajectory.true_poses.insert(trajectory.true_poses.begin(), compose(trajectory.true_poses.front(), inverse(step)));
    trajectory.poses.insert(trajectory.poses.begin(), compose(trajectory.poses.front(), inverse(measured)));
  }
  const Matrix3d S = std.cwiseAbs2().asDiagonal();
  for (int k = 1; k <= steps; ++k)
  {
    // Propagates the covariance over one step more, into the axes at its end.
    Matrix3d E = Matrix3d::Zero();
    for (int j = 0; j < k; ++j)
    {
      const Matrix3d turn = composeJacobianSecond({0, 0, -step.phi}), J = composeJacobianFirst({}, step);
      E = turn * (J * E * J.transpose() + S) * turn.transpose();
    }
    trajectory.covariances.insert(trajectory.covariances.begin(), E);
  }
  return trajectory;
}
}  // namespace mrpt_ext
