#pragma once

#include <vector>

#include "mrpt_ext/solvers/window_landmark.h"
#include "mrpt_ext/solvers/window_pose.h"
#include "random_scene.h"

namespace mrpt_ext
{
/// A way of equal steps as it was, as odometry tells it, and how far odometry is to be trusted.
struct Way
{
  std::vector<Pose2> true_places;     ///< robot poses in the world, oldest first
  std::vector<Pose2> places;          ///< by odometry, in the robot frame of now
  std::vector<Matrix3d> covariances;  ///< of the way from each place to now, as errors of the robot's pose now

  [[nodiscard]] const Pose2& now() const { return true_places.back(); }
};

/// `steps` moves of `step` that end at `end`; every move has independent noise `std` (x, y, phi) in odometry.
inline Way makeWay(const Pose2& end, const Pose2& step, int steps, const Vector3d& std, RandomStream& random)
{
  Way way;
  way.true_places = {end};
  way.places = {Pose2{}};
  way.covariances = {Matrix3d::Zero()};
  for (int k = 0; k < steps; ++k)
  {
    const Pose2 measured{step.x + std.x() * random.gaussian(), step.y + std.y() * random.gaussian(),
                         step.phi + std.z() * random.gaussian()};
    way.true_places.insert(way.true_places.begin(), compose(way.true_places.front(), inverse(step)));
    way.places.insert(way.places.begin(), compose(way.places.front(), inverse(measured)));
  }
  const Matrix3d S = std.cwiseAbs2().asDiagonal();
  for (int k = 1; k <= steps; ++k)
  {
    // The newest step last: what was known of the older ones is seen from the end of it.
    Matrix3d E = Matrix3d::Zero();
    for (int j = 0; j < k; ++j)
    {
      const Matrix3d turn = composeJacobianSecond({0, 0, -step.phi}), J = composeJacobianFirst({}, step);
      E = turn * (J * E * J.transpose() + S) * turn.transpose();
    }
    way.covariances.insert(way.covariances.begin(), E);
  }
  return way;
}
}  // namespace mrpt_ext
